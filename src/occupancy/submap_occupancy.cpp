// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/submap_occupancy.h"

#include <algorithm>

namespace revisit_slam {

void BlockCounts::set(int bit, int hits, int misses) {
  if (hits & 1) planes[kHitLow].set(bit);
  if (hits & 2) planes[kHitHigh].set(bit);
  if (misses & 1) planes[kMissLow].set(bit);
  if (misses & 2) planes[kMissHigh].set(bit);
}

void SubmapOccupancy::append(const Voxel& block, const BlockCounts& counts) {
  Entry entry{block, 0, static_cast<std::uint32_t>(planes_.size())};
  for (int plane = 0; plane < BlockCounts::kPlanes; ++plane) {
    if (!counts.planes[plane].any()) continue;
    entry.planes = static_cast<std::uint8_t>(entry.planes | 1 << plane);
    planes_.push_back(counts.planes[plane]);
  }
  if (entry.planes != 0) entries_.push_back(entry);
}

void SubmapOccupancy::shrinkToFit() {
  entries_.shrink_to_fit();
  planes_.shrink_to_fit();
}

BlockCounts SubmapOccupancy::counts(const Entry& entry) const {
  BlockCounts counts;
  std::uint32_t next = entry.first;
  for (int plane = 0; plane < BlockCounts::kPlanes; ++plane)
    if (entry.planes >> plane & 1) counts.planes[plane] = planes_[next++];
  return counts;
}

std::vector<SubmapOccupancy::Entry>::const_iterator SubmapOccupancy::firstFrom(
    const Voxel& block) const {
  return std::lower_bound(
      entries_.begin(), entries_.end(), block,
      [](const Entry& entry, const Voxel& wanted) { return BlockOrder()(entry.block, wanted); });
}

std::size_t SubmapOccupancy::bytes() const {
  return entries_.capacity() * sizeof(Entry) + planes_.capacity() * sizeof(VoxelMask);
}

}  // namespace revisit_slam
