// SPDX-License-Identifier: MIT
#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {

/// Which voxels have been seen. A voxel is a bit of a block of 8 x 8 x 8: those of a surface take a
/// byte or two each and stay in the caches of the processor, and points that follow each other are
/// mostly in one block, which is not searched for again.
class VoxelSet {
 public:
  /// @return whether it was not in the set.
  bool insert(const Voxel& voxel) {
    const std::uint64_t key = packVoxel(Voxel(voxel.x() >> 3, voxel.y() >> 3, voxel.z() >> 3));
    if (key != last_key_) lookAt(key);
    std::uint64_t& row = blocks_[last_][static_cast<std::size_t>(voxel.x() & 7)];
    const std::uint64_t bit = std::uint64_t{1} << ((voxel.y() & 7) << 3 | (voxel.z() & 7));
    const bool is_new = (row & bit) == 0;
    row |= bit;
    return is_new;
  }

  /// Keeps the memory for the next use.
  void clear() {
    block_of_.clear();
    blocks_.clear();
    last_key_ = kNoKey;
  }

 private:
  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};  // no packed voxel

  void lookAt(std::uint64_t key) {
    const auto [block, added] =
        block_of_.try_emplace(key, static_cast<std::uint32_t>(blocks_.size()));
    if (added) blocks_.push_back({});
    last_key_ = key;
    last_ = block->second;
  }

  tsl::robin_map<std::uint64_t, std::uint32_t, VoxelKeyHash> block_of_;
  std::vector<std::array<std::uint64_t, 8>> blocks_;  // rows by x, bits by y, then z
  std::uint64_t last_key_ = kNoKey;
  std::uint32_t last_ = 0;
};

}  // namespace revisit_slam
