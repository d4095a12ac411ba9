// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_set.h>

#include "revisit_slam/geometry/voxel.h"
#include "revisit_slam/occupancy/occupancy_voxels.h"

namespace revisit_slam {

/// Voxels of the occupancy map in which points of what moved lie, and nothing else.
class DynamicVoxels {
 public:
  /// `resolution` of the occupancy map, m.
  explicit DynamicVoxels(double resolution) : scale_(static_cast<float>(1.0 / resolution)) {}

  /// Of a part of the map's cloud: what stands, and what moved.
  void add(const Points& kept_map, const Points& dynamic_map);
  /// Makes them free. So are occupied voxels beside them without any point: submaps are composed at
  /// rounded poses.
  void clear(OccupancyVoxels& map) const;

 private:
  using Keys = tsl::robin_set<std::uint64_t, VoxelKeyHash>;

  bool isBesideDynamic(const Voxel& voxel) const;

  float scale_;  // voxels per metre
  Keys kept_, dynamic_;
};

}  // namespace revisit_slam
