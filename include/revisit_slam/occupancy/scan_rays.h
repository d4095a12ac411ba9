// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/occupancy/occupancy_block_table.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// What one scan says about a block: voxels with points in them, and voxels that rays passed on
/// their way to a point. No voxel is both: a point wins.
struct ScanRaysBlock {
  Voxel block;
  VoxelMask hit;
  VoxelMask miss;
  /// Ends of rays that were cut off at the longest range.
  VoxelMask cut;
};

/// Follows the rays of scans through a voxel grid; one ray for each voxel in which rays end.
class ScanRays {
 public:
  /// Both in metres.
  ScanRays(double resolution, double max_ray)
      : scale_(static_cast<float>(1.0 / resolution)), max_ray_(static_cast<float>(max_ray)) {}

  /// @param points in frame b; @param sensor_b where their rays start, in frame b.
  /// @return the blocks seen, in the grid of frame g, valid until the next call.
  const std::vector<ScanRaysBlock>& cast(const Points& points, const Pose& T_g_b,
                                         const Eigen::Vector3d& sensor_b) {
    return cast(points, T_g_b, std::vector<PointsView>{{sensor_b, points.size()}});
  }
  /// The same for points of several sensors.
  const std::vector<ScanRaysBlock>& cast(const Points& points, const Pose& T_g_b,
                                         const std::vector<PointsView>& views_b);

 private:
  void castFrom(const Eigen::Vector3f& from, const Eigen::Vector3f& to);
  void clear(const Eigen::Vector3f& end, const Eigen::Vector3f& sensor);

  float scale_;    // voxels per metre
  float max_ray_;  // metres
  OccupancyBlockTable<ScanRaysBlock> table_;
  Voxel previous_;  // in which the ray before ended
};

}  // namespace revisit_slam
