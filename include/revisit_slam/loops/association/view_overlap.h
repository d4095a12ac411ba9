// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_set.h>

#include <cstdint>

#include "revisit_slam/geometry/voxel.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// What a submap sees, coarsely: one point of each occupied cube of 3 m, times the scale of its
/// surroundings. That is wide enough for poses that are off by a metre or two.
class CoarseView {
 public:
  explicit CoarseView(const Points& points, double scale = 1.0);

  /// Of views of one scale: the share of cubes of either submap, of the one that has more, that the
  /// other sees too: 0 … 1.
  static double overlap(const CoarseView& source, const CoarseView& target,
                        const Pose& T_target_source);

 private:
  float edge_;  // m
  Points points_;
  tsl::robin_set<std::uint64_t, VoxelKeyHash> cubes_;
};

}  // namespace revisit_slam
