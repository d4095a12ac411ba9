// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "revisit_slam/evaluation/trajectory_match.h"

namespace revisit_slam {

/// Error of the motion over one subsequence, divided by its length.
struct SubsequenceError {
  std::size_t first = 0;     ///< index into the match
  double length = 0.0;       ///< m: 100, 200 … 800
  double translation = 0.0;  ///< metres a metre
  double rotation = 0.0;     ///< radians a metre
};

/// Relative pose error of the KITTI odometry benchmark (Geiger et al., CVPR 2012).
struct RelativeError {
  /// Means over all subsequences of all lengths; NaN where the drive is too short for any.
  double translation_percent = 0.0;
  double rotation_deg_per_m = 0.0;
  std::vector<SubsequenceError> subsequences;
};

constexpr std::array<double, 8> kSubsequenceLengths{100, 200, 300, 400, 500, 600, 700, 800};

/// As the benchmark's development kit: a subsequence starts at every tenth pose and ends at the
/// first pose whose way along the reference is more than its length beyond the start. Its error is
/// (estimated motion)^-1 * (true motion): the norm of the translation and the angle of the
/// rotation, divided by the nominal length. Lengths that do not fit are left out.
RelativeError relativeError(const TrajectoryMatch& match);

}  // namespace revisit_slam
