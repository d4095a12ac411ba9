// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/registered_scan.h"

namespace revisit_slam {

/// What a trajectory needs of a scan: all but its points. For scans that wait in great number.
RegisteredScanPtr withoutPoints(const RegisteredScan& scan);

}  // namespace revisit_slam
