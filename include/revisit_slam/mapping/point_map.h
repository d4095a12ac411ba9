// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/geometry/voxel_set.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// A cloud of a whole drive: the first point seen in each voxel.
class PointMap {
 public:
  /// `voxel_size` in metres.
  explicit PointMap(double voxel_size) : voxels_per_metre_(1.0 / voxel_size) {}

  /// `intensities`: one for each point, or none.
  void insert(const Points& points_base, const Pose& T_world_base,
              const std::vector<float>& intensities = {});
  const Points& points() const { return points_; }
  /// Of the points, 0 where one has none; empty where none has one.
  const std::vector<float>& intensities() const { return intensities_; }

 private:
  double voxels_per_metre_;
  Points points_;
  std::vector<float> intensities_;
  VoxelSet seen_;
};

}  // namespace revisit_slam
