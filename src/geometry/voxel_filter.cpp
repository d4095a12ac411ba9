// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_filter.h"

#include <tsl/robin_map.h>

#include <algorithm>

#include "revisit_slam/geometry/spread_order.h"
#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {
namespace {

constexpr int kBitsPerAxis = 17;
constexpr int kKeyBits = 3 * kBitsPerAxis;
constexpr std::uint64_t kLargestCall = (std::uint64_t{1} << (64 - kKeyBits)) - 1;

/// Teschner et al., "Optimized Spatial Hashing", VMV 2003, with KISS-ICP's second factor.
struct SpatialHash {
  std::size_t operator()(const Voxel& voxel) const {
    const auto part = [&](int axis, std::uint32_t factor) {
      return static_cast<std::uint32_t>(voxel[axis]) * factor;
    };
    return part(0, 73856093) ^ part(1, 19349669) ^ part(2, 83492791);
  }
};

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

const VoxelFilter::Indices& VoxelFilter::filterHashed(const Points& input, double voxel_size,
                                                      Points& output) {
  tsl::robin_map<Voxel, std::uint32_t, SpatialHash> first_of;
  first_of.reserve(input.size());
  for (std::size_t i = 0; i < input.size(); ++i)
    first_of.try_emplace(voxelOf<double>(input[i].cast<double>() / voxel_size),
                         static_cast<std::uint32_t>(i));
  output.clear();
  kept_.clear();
  for (const auto& [voxel, index] : first_of) {
    output.push_back(input[index]);
    kept_.push_back(index);
  }
  return kept_;
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
