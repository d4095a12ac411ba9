// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/simulation/mover.h"
#include "revisit_slam/simulation/route.h"

namespace revisit_slam::simulation {

/// Oncoming, leading and following cars on the route's road, at most `most` of them. None ever
/// overlaps the platform or another.
std::vector<Mover> makeTraffic(const Route& route, int most);

}  // namespace revisit_slam::simulation
