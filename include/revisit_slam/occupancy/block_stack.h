// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/occupancy/occupancy_voxels.h"

namespace revisit_slam {

/// The blocks of the map above each other at one place, lowest first.
struct BlockStack {
  using Block = std::vector<OccupancyBlock>::const_iterator;

  static constexpr int kColumns = kBlockEdge * kBlockEdge;

  Eigen::Vector2i place;  // x and y of its blocks
  Block begin, end;

  /// Where column `c` stands within the block.
  static Eigen::Vector2i inBlock(int c) { return {c / kBlockEdge, c % kBlockEdge}; }
  /// The voxels of column `c` of a block, the lowest in bit 0.
  static unsigned column(const VoxelMask& mask, int c) {
    return mask.words[c / kBlockEdge] >> (kBlockEdge * (c % kBlockEdge)) & 0xff;
  }
  /// z of the lowest occupied voxel of column `c`.
  std::optional<int> lowestOccupied(int c) const;
};

/// Ordered by place: x, then y. They point into `blocks`, which are in BlockOrder.
std::vector<BlockStack> stacksOf(const std::vector<OccupancyBlock>& blocks);

/// Null where there is none.
const BlockStack* findStack(const std::vector<BlockStack>& stacks, const Eigen::Vector2i& place);

}  // namespace revisit_slam
