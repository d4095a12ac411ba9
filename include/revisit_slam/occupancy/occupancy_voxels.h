// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "revisit_slam/occupancy/occupancy_block.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// One block of a map; a voxel that is neither occupied nor free is unknown.
struct OccupancyBlock {
  Voxel block;
  VoxelMask occupied;
  VoxelMask free;
  VoxelMask driven = {};  ///< the robot was there; these are free

  bool isKnown() const { return occupied.any() || free.any(); }
};

/// What of a map is occupied and what is free.
struct OccupancyVoxels {
  double resolution = 0.0;             ///< edge of a voxel, m
  std::vector<OccupancyBlock> blocks;  ///< in BlockOrder, each once, all known

  /// Makes occupied voxels free where `is_free` says so.
  void markFree(const std::function<bool(const Voxel&)>& is_free);
};

/// Centres of the occupied voxels, in the map frame, ordered by block.
Points occupiedCentres(const OccupancyVoxels& map);

}  // namespace revisit_slam
