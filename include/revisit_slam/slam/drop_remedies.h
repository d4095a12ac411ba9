// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/types/scan_account.h"

namespace revisit_slam {

/// What a user can do about scans that are dropped for this reason; empty where nothing is known.
std::string remedyForDrop(const std::string& reason);

/// The reason for which most scans were dropped, and the remedy: "29 of 30 scans dropped, 29 of
/// them for 'no stamp': let the driver …"; empty where none was dropped.
std::string describeDrops(const ScanAccount& account);

}  // namespace revisit_slam
