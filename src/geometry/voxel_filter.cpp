// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_filter.h"

#include <algorithm>

#include "revisit_slam/geometry/spread_order.h"
#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {
namespace {

constexpr int kBitsPerAxis = 17;
constexpr int kKeyBits = 3 * kBitsPerAxis;
constexpr std::uint64_t kLargestCall = (std::uint64_t{1} << (64 - kKeyBits)) - 1;

}  // namespace

const VoxelFilter::Indices& VoxelFilter::filter(const Points& input, double voxel_size,
                                                Points& output) {
  return filterInOrder(input, voxel_size, output, [i = std::size_t{0}]() mutable { return i++; });
}

const VoxelFilter::Indices& VoxelFilter::filterSpread(const Points& input, double voxel_size,
                                                      Points& output) {
  SpreadOrder order(input.size());
  return filterInOrder(input, voxel_size, output, [&] { return order.next(); });
}

template <typename NextIndex>
const VoxelFilter::Indices& VoxelFilter::filterInOrder(const Points& input, double voxel_size,
                                                       Points& output, NextIndex next) {
  output.clear();
  kept_.clear();
  prepareTable(input.size());
  const float scale = static_cast<float>(1.0 / voxel_size);
  std::uint64_t previous_key = ~std::uint64_t{0};  // no packed voxel: neighbours on a ring repeat
  for (std::size_t i = 0; i < input.size(); ++i) {
    const std::size_t index = next();
    const Eigen::Vector3f& point = input[index];
    const std::uint64_t key = packVoxel<kBitsPerAxis>(voxelOf<float>(point * scale));
    if (key == previous_key) continue;
    previous_key = key;
    if (!insert(key)) continue;
    output.push_back(point);
    kept_.push_back(static_cast<std::uint32_t>(index));
  }
  return kept_;
}

void VoxelFilter::prepareTable(std::size_t points) {
  std::size_t size = std::max<std::size_t>(table_.size(), 1024);
  while (size < 2 * points) size *= 2;
  if (size > table_.size() || call_ == kLargestCall) {
    table_.assign(size, 0);
    mask_ = size - 1;
    call_ = 0;
  }
  ++call_;
}

bool VoxelFilter::insert(std::uint64_t key) {
  const std::uint64_t entry = call_ << kKeyBits | key;
  for (std::uint64_t slot = mixVoxelKey(key) >> 20 & mask_;; slot = (slot + 1) & mask_) {
    if (table_[slot] == entry) return false;
    if (table_[slot] >> kKeyBits != call_) {
      table_[slot] = entry;
      return true;
    }
  }
}

}  // namespace revisit_slam
