// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/random.h"
#include "site.h"

namespace revisit_slam::simulation {

/// The sizes and gaps of the houses along the roads of a world. Metres.
struct BuildingStyle {
  double narrowest = 8.0;
  double widest = 22.0;
  double shallowest = 8.0;
  double deepest = 15.0;
  double nearest = 2.6;
  double farthest = 8.0;
  int highest_storeys = 5;
  double gap_share = 0.35;
};

/// Houses in rows along all roads, each with its own footprint, height, roof and walls, and some
/// in the second row.
void addBuildings(Site& site, const BuildingStyle& style);

/// One house on a plot, its front towards -y of the plot's centre.
void addHouse(TriangleMesh& mesh, const Plot& plot, double height, Random& random);

}  // namespace revisit_slam::simulation
