// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "revisit_slam/occupancy/submap_occupancy.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Sums of what submaps say about the voxels of one block of the map.
struct BlockEvidence {
  std::array<std::uint32_t, kBlockVoxels> hits{};
  std::array<std::uint32_t, kBlockVoxels> misses{};
  VoxelMask driven;  ///< the robot was there
};

/// The blocks of the map in which the submap may say something, in BlockOrder, each once.
std::vector<Voxel> blocksReached(const SubmapOccupancy& submap, const Pose& T_map_submap);

/// Adds what the submap says about the block. A voxel of the map takes the counts of the voxel of
/// the submap in which its centre lies: so turning leaves no holes. A hit that reaches no voxel in
/// this way goes to the voxel in which its own centre lies: so turning loses no thin pole.
void addEvidence(const SubmapOccupancy& submap, const Pose& T_map_submap, const Voxel& block,
                 BlockEvidence& evidence);

}  // namespace revisit_slam
