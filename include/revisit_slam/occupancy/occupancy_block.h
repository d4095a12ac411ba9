// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {

/// Voxels are kept in cubic blocks of kBlockEdge voxels a side. Block b holds the voxels
/// kBlockEdge * b to kBlockEdge * b + kBlockEdge - 1, per axis.
constexpr int kBlockEdge = 8;
constexpr int kBlockVoxels = kBlockEdge * kBlockEdge * kBlockEdge;

inline Voxel blockOf(const Voxel& voxel) {
  return {voxel.x() >> 3, voxel.y() >> 3, voxel.z() >> 3};
}

/// Number of a voxel within its block: x, then y, then z.
inline int bitOf(const Voxel& voxel) {
  return (voxel.x() & 7) << 6 | (voxel.y() & 7) << 3 | (voxel.z() & 7);
}

inline Voxel voxelAt(const Voxel& block, int bit) {
  return kBlockEdge * block + Voxel(bit >> 6, bit >> 3 & 7, bit & 7);
}

/// x, then y, then z: the blocks of a column follow each other.
struct BlockOrder {
  bool operator()(const Voxel& a, const Voxel& b) const {
    return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
  }
};

/// One bit for each voxel of a block.
struct VoxelMask {
  std::array<std::uint64_t, kBlockEdge> words{};

  bool test(int bit) const { return words[bit >> 6] >> (bit & 63) & 1; }
  void set(int bit) { words[bit >> 6] |= std::uint64_t{1} << (bit & 63); }
  bool any() const {
    std::uint64_t together = 0;
    for (const std::uint64_t word : words) together |= word;
    return together != 0;
  }

  /// Calls visit(bit) for each bit that is set, in order.
  template <typename Visit>
  void forEach(Visit visit) const {
    for (int w = 0; w < kBlockEdge; ++w)
      for (std::uint64_t rest = words[w]; rest != 0; rest &= rest - 1)
        visit(w << 6 | __builtin_ctzll(rest));
  }

  friend VoxelMask operator|(VoxelMask a, const VoxelMask& b) {
    for (int w = 0; w < kBlockEdge; ++w) a.words[w] |= b.words[w];
    return a;
  }
  friend VoxelMask operator&(VoxelMask a, const VoxelMask& b) {
    for (int w = 0; w < kBlockEdge; ++w) a.words[w] &= b.words[w];
    return a;
  }
  friend VoxelMask operator^(VoxelMask a, const VoxelMask& b) {
    for (int w = 0; w < kBlockEdge; ++w) a.words[w] ^= b.words[w];
    return a;
  }
  friend VoxelMask operator~(VoxelMask a) {
    for (std::uint64_t& word : a.words) word = ~word;
    return a;
  }
  friend bool operator==(const VoxelMask& a, const VoxelMask& b) { return a.words == b.words; }
};

}  // namespace revisit_slam
