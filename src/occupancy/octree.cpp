// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/octree.h"

#include <stdexcept>

namespace revisit_slam {
namespace {

constexpr int kHalf = 32768;  // voxels from the origin to the border; the key of voxel 0

octomap::OcTreeKey keyOf(const Voxel& voxel) {
  const auto key = [](int index) { return static_cast<octomap::key_type>(index + kHalf); };
  return {key(voxel.x()), key(voxel.y()), key(voxel.z())};
}

bool fits(const Voxel& block) {
  constexpr int kHalfBlocks = kHalf / kBlockEdge;
  return block.minCoeff() >= -kHalfBlocks && block.maxCoeff() < kHalfBlocks;
}

}  // namespace

std::unique_ptr<octomap::OcTree> octreeOf(const OccupancyMap& map) {
  auto tree = std::make_unique<octomap::OcTree>(map.resolution());
  for (const OccupancyBlock& block : map.blocks()) {
    if (!fits(block.block))
      throw std::runtime_error("the map is larger than an octree of 16 levels");
    // Not lazily: equal children become one node at once, so the tree never takes more memory than
    // when it is pruned.
    const auto put = [&](const VoxelMask& mask, float log_odds) {
      mask.forEach(
          [&](int bit) { tree->setNodeValue(keyOf(voxelAt(block.block, bit)), log_odds, false); });
    };
    put(block.occupied, tree->getClampingThresMaxLog());
    put(block.free, tree->getClampingThresMinLog());
  }
  return tree;
}

}  // namespace revisit_slam
