// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/octree.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

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

void put(const OccupancyBlock& block, const Voxel& origin_block, octomap::OcTree& tree) {
  const Voxel place = block.block - origin_block;
  if (!fits(place)) throw std::runtime_error("the map is larger than an octree of 16 levels");
  // Not lazily: equal children become one node at once, so the tree never takes more memory than
  // when it is pruned.
  const auto mark = [&](const VoxelMask& mask, float log_odds) {
    mask.forEach([&](int bit) { tree.setNodeValue(keyOf(voxelAt(place, bit)), log_odds, false); });
  };
  mark(block.occupied, tree.getClampingThresMaxLog());
  mark(block.free, tree.getClampingThresMinLog());
}

constexpr int kTileBlocks = kOctreeTile / kBlockEdge;

Eigen::Vector2i tileOf(const Voxel& block) {
  const auto floorOf = [](int i) { return i >= 0 ? i / kTileBlocks : -1 - (-1 - i) / kTileBlocks; };
  return {floorOf(block.x()), floorOf(block.y())};
}

}  // namespace

std::unique_ptr<octomap::OcTree> octreeOf(const OccupancyVoxels& map) {
  auto tree = std::make_unique<octomap::OcTree>(map.resolution);
  for (const OccupancyBlock& block : map.blocks) put(block, Voxel::Zero(), *tree);
  return tree;
}

bool fitsOctree(const OccupancyVoxels& map) {
  return std::all_of(map.blocks.begin(), map.blocks.end(),
                     [](const OccupancyBlock& block) { return fits(block.block); });
}

void forEachOctreeTile(const OccupancyVoxels& map,
                       const std::function<void(const OctreeTile&)>& take) {
  std::map<std::pair<int, int>, std::vector<const OccupancyBlock*>> tiles;
  for (const OccupancyBlock& block : map.blocks) {
    const Eigen::Vector2i number = tileOf(block.block);
    tiles[{number.x(), number.y()}].push_back(&block);
  }
  for (const auto& [number, blocks] : tiles) {
    const Voxel origin(kTileBlocks * number.first + kTileBlocks / 2,
                       kTileBlocks * number.second + kTileBlocks / 2, 0);
    OctreeTile tile{{number.first, number.second},
                    map.resolution * kBlockEdge * origin.cast<double>(),
                    std::make_unique<octomap::OcTree>(map.resolution)};
    for (const OccupancyBlock* block : blocks) put(*block, origin, *tile.tree);
    take(tile);
  }
}

}  // namespace revisit_slam
