// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <vector>

#include "revisit_slam/occupancy/occupancy_block.h"

namespace revisit_slam {

/// Blocks found by their coordinates, in the order in which they were first asked for. `Block` has
/// a member `block` and is empty when made from nothing.
template <typename Block>
class OccupancyBlockTable {
 public:
  /// The block, added if it was not there; valid until the next call.
  Block& at(const Voxel& block) {
    const auto [place, added] =
        index_.try_emplace(packVoxel(block), static_cast<std::uint32_t>(blocks_.size()));
    if (added) {
      blocks_.emplace_back();
      blocks_.back().block = block;
    }
    return blocks_[place->second];
  }

  const std::vector<Block>& blocks() const { return blocks_; }
  std::vector<Block>& blocks() { return blocks_; }

  /// Keeps the memory for the next use.
  void clear() {
    index_.clear();
    blocks_.clear();
  }

 private:
  tsl::robin_map<std::uint64_t, std::uint32_t, VoxelKeyHash> index_;
  std::vector<Block> blocks_;
};

}  // namespace revisit_slam
