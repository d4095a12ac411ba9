// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// How thick surfaces are that several maps of one place show together.
struct PlaneThickness {
  double squared_sum = 0.0;  ///< m^2, over the points
  std::size_t points = 0;    ///< in cubes that more than one map has points in

  PlaneThickness& operator+=(const PlaneThickness& other);
  /// m; NaN without points.
  double rms() const;
};

/// The maps, in one frame, are laid into one another and cut into cubes of `edge`. The thickness of
/// a cube is the standard deviation of its points across the plane that fits them best; of all
/// cubes it is the root of the mean variance, the mean plane variance of Razlaw et al., ECMR 2015.
/// Cubes count by their points, and only if at least two maps have a handful of points in them.
/// Unlike nearest neighbours it needs no pairs and no largest distance.
PlaneThickness planeThickness(const std::vector<Points>& maps, double edge);

}  // namespace revisit_slam
