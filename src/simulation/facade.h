// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/random.h"
#include "shapes.h"

namespace revisit_slam::simulation {

/// What the walls of one house have in common. Metres.
struct FacadeStyle {
  double bay = 3.0;
  double storey = 3.0;
  double window_width = 1.2;
  double window_height = 1.5;
  double sill = 0.9;
  double recess = 0.18;
  double balcony_share = 0.15;
  double bay_window_share = 0.1;
  double pilaster_share = 0.2;
  Material wall = Material::kPlaster;
};

FacadeStyle randomFacadeStyle(Random& random);

/// A wall with windows, doors, balconies, bays and pilasters. In `wall`, x runs along the wall from
/// 0 to `width`, y points outwards and z up from 0 to `height`; below z = 0 the wall goes on.
void addFacade(TriangleMesh& mesh, const Placement& wall, double width, double height,
               const FacadeStyle& style, Random& random);

}  // namespace revisit_slam::simulation
