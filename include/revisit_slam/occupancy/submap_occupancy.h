// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "revisit_slam/occupancy/occupancy_block.h"

namespace revisit_slam {

/// How often the voxels of one block were hit and passed, 0 to kMostCount each, and in which of
/// them the robot was. A count is two bit planes, low and high.
struct BlockCounts {
  static constexpr int kMostCount = 3;
  enum Plane { kHitLow, kHitHigh, kMissLow, kMissHigh, kDriven, kPlanes };

  std::array<VoxelMask, kPlanes> planes;

  std::uint32_t hits(int bit) const { return count(kHitLow, bit); }
  std::uint32_t misses(int bit) const { return count(kMissLow, bit); }
  bool driven(int bit) const { return planes[kDriven].test(bit); }
  VoxelMask hit() const { return planes[kHitLow] | planes[kHitHigh]; }
  void set(int bit, int hits, int misses);

 private:
  std::uint32_t count(int low, int bit) const {
    return planes[low].test(bit) + 2u * planes[low + 1].test(bit);
  }
};

/// What the scans of one submap saw of the space around it, immutable: the evidence that follows
/// the submap when the graph moves it. Planes of counts without a bit are not kept.
class SubmapOccupancy {
 public:
  struct Entry {
    Voxel block;
    std::uint8_t planes;  // bit i: plane i is kept
    std::uint32_t first;  // of its planes
  };

  /// `resolution` is the edge of a voxel, metres; voxels are those of the submap's frame.
  explicit SubmapOccupancy(double resolution) : resolution_(resolution) {}

  /// Blocks come in BlockOrder.
  void append(const Voxel& block, const BlockCounts& counts);
  void shrinkToFit();

  double resolution() const { return resolution_; }
  const std::vector<Entry>& entries() const { return entries_; }
  BlockCounts counts(const Entry& entry) const;
  /// The first entry that is not before the block, in BlockOrder.
  std::vector<Entry>::const_iterator firstFrom(const Voxel& block) const;
  /// Memory held, bytes.
  std::size_t bytes() const;

 private:
  double resolution_;
  std::vector<Entry> entries_;
  std::vector<VoxelMask> planes_;
};

using SubmapOccupancyPtr = std::shared_ptr<const SubmapOccupancy>;

}  // namespace revisit_slam
