// SPDX-License-Identifier: MIT
#pragma once

#include <octomap/OcTree.h>

#include <functional>
#include <memory>

#include "revisit_slam/occupancy/occupancy_voxels.h"

namespace revisit_slam {

/// The map as an octree of OctoMap, pruned. Its leaves are certain (at the clamping thresholds of
/// OctoMap), as in a file of occupied, free and unknown voxels. It takes many times the memory of
/// the map and is meant to be written or sent and dropped.
/// @throws std::runtime_error where the map reaches beyond an octree of 16 levels, whose border is
/// 32768 voxels from the origin.
std::unique_ptr<octomap::OcTree> octreeOf(const OccupancyVoxels& map);

/// A square of the map as an octree whose origin is in the middle of the square.
struct OctreeTile {
  Eigen::Vector2i number;      ///< of the square, along x and y
  Eigen::Vector3d origin_map;  ///< where the origin of the octree is in the map, m
  std::unique_ptr<octomap::OcTree> tree;
};

/// Whether octreeOf can take the map.
bool fitsOctree(const OccupancyVoxels& map);

/// Edge of the squares, voxels.
constexpr int kOctreeTile = 32768;

/// Hands out the map square by square, one in memory at a time.
void forEachOctreeTile(const OccupancyVoxels& map,
                       const std::function<void(const OctreeTile&)>& take);

}  // namespace revisit_slam
