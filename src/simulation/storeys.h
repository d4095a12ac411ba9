// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/polyline.h"

namespace revisit_slam::simulation {

/// Up through all storeys of a building, around on each, and down again, until `length` is reached.
/// Heights are those of the floors; the storeys lie above each other in xy. Metres.
Polyline throughStoreys(double length);

}  // namespace revisit_slam::simulation
