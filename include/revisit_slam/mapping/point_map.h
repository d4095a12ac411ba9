// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_map.h>

#include "revisit_slam/geometry/voxel.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// A cloud of a whole drive: the first point seen in each voxel.
class PointMap {
 public:
  /// `voxel_size` in metres.
  explicit PointMap(double voxel_size) : voxel_size_(voxel_size) {}

  void insert(const Points& points_base, const Pose& T_world_base);
  const Points& points() const { return points_; }

 private:
  double voxel_size_;
  Points points_;
  tsl::robin_map<std::uint64_t, char, VoxelKeyHash> seen_;
};

}  // namespace revisit_slam
