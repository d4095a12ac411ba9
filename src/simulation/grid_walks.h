// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/simulation/layout.h"
#include "revisit_slam/simulation/route_config.h"

namespace revisit_slam::simulation {

/// A way over the crossings of a street grid. A closed walk ends where it begins and is repeated;
/// an open one is as long as the route.
struct GridWalk {
  std::vector<GridNode> nodes;
  bool closed;
  /// Size of the blocks with which the promised revisits fit into the length, metres.
  double block;
};

/// @param usual_block the size of blocks where the length does not ask for smaller ones.
GridWalk makeWalk(const RouteConfig& config, double usual_block);

}  // namespace revisit_slam::simulation
