// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/occupancy/occupancy_voxels.h"
#include "revisit_slam/occupancy/submap_occupancy.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Sums of what submaps say about the voxels of one block of the map.
struct BlockEvidence {
  std::array<std::uint32_t, kBlockVoxels> hits{};
  std::array<std::uint32_t, kBlockVoxels> misses{};
  VoxelMask driven;  ///< the robot was there
};

/// The state of the voxels of a block by the log odds of hits and misses. Where the robot drove
/// nothing is occupied.
OccupancyBlock decide(const Voxel& block, const BlockEvidence& evidence,
                      const OccupancyConfig& config);

/// The pose in steps that move no point within max_ray of the keypose by more than pose_step
/// voxels; half of that for the translation, half for the rotation.
Pose roundedPose(const Pose& T_map_submap, const OccupancyConfig& config);

/// @throws std::invalid_argument for another resolution than the map's.
void checkResolution(SubmapId id, const SubmapOccupancy& occupancy, const OccupancyConfig& config);

}  // namespace revisit_slam
