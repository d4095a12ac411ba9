// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/voxel_mean_grid.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

constexpr std::uint64_t kNoVoxel = ~std::uint64_t{0};
constexpr int kBits = 21;

/// The voxel that packVoxel made the key of.
Voxel unpackVoxel(std::uint64_t key) {
  constexpr std::uint64_t mask = (std::uint64_t{1} << kBits) - 1;
  const auto part = [&](int shift) {
    return static_cast<int>(key >> shift & mask) - kVoxelLimit<kBits>;
  };
  return {part(2 * kBits), part(kBits), part(0)};
}

}  // namespace

void VoxelMeanGrid::insert(const Points& points, const Pose& T_grid_points) {
  const Eigen::Matrix3f R = T_grid_points.rotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_grid_points.translation.cast<float>();
  const float scale = 1.0f / edge_;
  std::uint64_t previous = kNoVoxel;
  Cell* cell = nullptr;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f p = R * point + t;
    const Voxel voxel = voxelOf<float>(p * scale);
    const std::uint64_t key = packVoxel<kBits>(voxel);
    if (key != previous) cell = &cells_.try_emplace(key).first.value();
    previous = key;
    if (cell->count == kMostPoints) continue;
    cell->sum += p - centre(voxel);
    ++cell->count;
  }
}

VoxelMeans VoxelMeanGrid::take() {
  std::vector<std::pair<std::uint64_t, const Cell*>> order;
  order.reserve(cells_.size());
  for (const auto& [key, cell] : cells_) order.emplace_back(key, &cell);
  std::sort(order.begin(), order.end());
  VoxelMeans means;
  means.keys.reserve(order.size());
  means.points.reserve(order.size());
  for (const auto& [key, cell] : order) {
    means.keys.push_back(key);
    means.points.push_back(centre(unpackVoxel(key)) + cell->sum / static_cast<float>(cell->count));
  }
  cells_ = {};
  return means;
}

}  // namespace revisit_slam
