// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "revisit_slam/simulation/random.h"
#include "site.h"

namespace revisit_slam::simulation {

/// Calls `visit(place)` along both sides of all roads, on average every `spacing` metres, at
/// `offset` metres outside the road's edge. In the place x runs along the road, y away from it, and
/// z = 0 is the ground.
template <typename Visit>
void alongRoadsides(Site& site, Random& random, double spacing, double offset, Visit visit) {
  constexpr double kHalfPi = 1.5707963267948966;
  for (const Road& road : site.roads()) {
    const Polyline line = resampled(road.middle, 1.0);
    for (const double side : {-1.0, 1.0}) {
      double arc = random.uniform(0.0, spacing);
      for (; arc < static_cast<double>(line.size()); arc += spacing * random.uniform(0.85, 1.15)) {
        const auto k = static_cast<std::size_t>(arc);
        const Eigen::Vector2d along = directionAt(line, k);
        const Eigen::Vector2d aside = side * Eigen::Vector2d(-along.y(), along.x());
        const Eigen::Vector2d p = line[k].head<2>() + (road.half_width + offset) * aside;
        if (!site.isNear(p)) continue;
        visit(
            Placement{{p.x(), p.y(), site.ground(p)}, std::atan2(aside.y(), aside.x()) - kHalfPi});
      }
    }
  }
}

}  // namespace revisit_slam::simulation
