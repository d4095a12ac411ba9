// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "revisit_slam/evaluation/pose_interpolator.h"

namespace revisit_slam {

/// Poses of an estimate and, at the same index and stamp, of the reference.
struct TrajectoryMatch {
  Trajectory estimate;
  Trajectory reference;
  /// Poses of the estimate that are left out: before or after the reference, or where it has a gap.
  std::size_t outside = 0;
  std::size_t in_gap = 0;
};

/// The reference at the estimate's own stamps.
TrajectoryMatch matchToReference(const PoseInterpolator& estimate,
                                 const PoseInterpolator& reference);

/// Reads a TUM file, or a KITTI file of as many poses as `reference` has, which get the stamps of
/// these in order. The number of columns tells which.
/// @throws std::runtime_error naming the file.
Trajectory readTrajectory(const std::string& path, const Trajectory& reference = {});

}  // namespace revisit_slam
