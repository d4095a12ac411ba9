// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/evaluation/trajectory_match.h"

namespace revisit_slam {

/// Absolute trajectory error (paper Sec. IV-B): distances between positions in metres, the estimate
/// moved rigidly onto the reference.
struct AbsoluteError {
  Pose T_reference_estimate;
  double rmse = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double max = 0.0;
  std::vector<double> per_pose;
};

/// Aligns by the rotation and translation of least squares, without scale (Umeyama, PAMI 1991).
/// @throws std::runtime_error with fewer than three poses.
AbsoluteError absoluteError(const TrajectoryMatch& match);

}  // namespace revisit_slam
