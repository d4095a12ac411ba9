// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/block_stack.h"

#include <algorithm>

namespace revisit_slam {

std::optional<int> BlockStack::lowestOccupied(int c) const {
  for (Block block = begin; block != end; ++block)
    if (const unsigned occupied = column(block->occupied, c))
      return kBlockEdge * block->block.z() + __builtin_ctz(occupied);
  return std::nullopt;
}

std::vector<BlockStack> stacksOf(const std::vector<OccupancyBlock>& blocks) {
  std::vector<BlockStack> stacks;
  for (auto begin = blocks.begin(); begin != blocks.end(); begin = stacks.back().end) {
    const Eigen::Vector2i place = begin->block.head<2>();
    const auto end = std::find_if(begin, blocks.end(), [&](const OccupancyBlock& block) {
      return block.block.head<2>() != place;
    });
    stacks.push_back({place, begin, end});
  }
  return stacks;
}

const BlockStack* findStack(const std::vector<BlockStack>& stacks, const Eigen::Vector2i& place) {
  const auto found = std::lower_bound(
      stacks.begin(), stacks.end(), place, [](const BlockStack& a, const Eigen::Vector2i& wanted) {
        return a.place.x() != wanted.x() ? a.place.x() < wanted.x() : a.place.y() < wanted.y();
      });
  return found != stacks.end() && found->place == place ? &*found : nullptr;
}

}  // namespace revisit_slam
