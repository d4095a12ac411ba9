// SPDX-License-Identifier: MIT
#pragma once

#include "site.h"

namespace revisit_slam::simulation {

/// The surface of the land: fine near the route, coarse far from it, with holes for water.
void addGround(Site& site);

/// Walls or kerbs along both edges of the roads, interrupted where roads meet.
struct Edging {
  double height = 0.12;
  double thickness = 0.15;
  Material material = Material::kConcrete;
};
void addEdging(Site& site, const Edging& edging);

}  // namespace revisit_slam::simulation
