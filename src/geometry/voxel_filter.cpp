// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/voxel_filter.h"

#include <tsl/robin_map.h>

#include <algorithm>

#include "revisit_slam/geometry/grid_points.h"
#include "revisit_slam/geometry/spread_order.h"
#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {
namespace {

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
  seen_.clear();
  const float scale = static_cast<float>(1.0 / voxel_size);
  GridPoints<float> placed;
  Eigen::Vector3f batch[GridPoints<float>::kMost];
  std::uint32_t indices[GridPoints<float>::kMost];
  for (std::size_t begin = 0; begin < input.size(); begin += placed.kMost) {
    const std::size_t count = std::min(placed.kMost, input.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      indices[i] = static_cast<std::uint32_t>(next());
      batch[i] = input[indices[i]];
    }
    toGrid(batch, count, scale, placed);
    for (std::size_t i = 0; i < count; ++i) {
      if (!seen_.insert(placed.voxel(i))) continue;
      output.push_back(batch[i]);
      kept_.push_back(indices[i]);
    }
  }
  return kept_;
}

}  // namespace revisit_slam
