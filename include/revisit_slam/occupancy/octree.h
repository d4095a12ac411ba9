// SPDX-License-Identifier: MIT
#pragma once

#include <octomap/OcTree.h>

#include <memory>

#include "revisit_slam/occupancy/occupancy_map.h"

namespace revisit_slam {

/// The map as an octree of OctoMap, pruned. Its leaves are certain (at the clamping thresholds of
/// OctoMap), as in a file of occupied, free and unknown voxels. It takes many times the memory of
/// the map and is meant to be written or sent and dropped.
/// @throws std::runtime_error where the map reaches beyond an octree of 16 levels, whose border is
/// 32768 voxels from the origin.
std::unique_ptr<octomap::OcTree> octreeOf(const OccupancyMap& map);

}  // namespace revisit_slam
