// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// What the nearest neighbours of points sum up to.
struct NearestDistances {
  std::size_t points = 0;
  std::size_t paired = 0;    ///< points with a neighbour nearer than the limit
  double squared_sum = 0.0;  ///< m^2, over the paired points

  NearestDistances& operator+=(const NearestDistances& other);
  /// m; NaN without a pair.
  double rms() const;
  /// 0 to 1; NaN without points.
  double share() const;
};

/// The exact nearest neighbours of all points of `a` in `b` and of all points of `b` in `a`, in one
/// frame. Runs in the current TBB arena; the sums do not depend on its threads.
NearestDistances nearestDistances(const Points& a, const Points& b, double max_distance);

}  // namespace revisit_slam
