// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/voxel_mean_grid.h"

#include <limits>

namespace revisit_slam {
namespace {

const Voxel kNowhere = Voxel::Constant(std::numeric_limits<int>::max());

}  // namespace

void VoxelMeanGrid::insert(const Points& points, const Pose& T_grid_points) {
  const Eigen::Matrix3f R = T_grid_points.rotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_grid_points.translation.cast<float>();
  const float scale = 1.0f / edge_;
  Voxel previous = kNowhere;
  Cell* cell = nullptr;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f p = R * point + t;
    const Voxel voxel = voxelOf<float>(p * scale);
    if (voxel != previous) cell = &cellAt(voxel);
    previous = voxel;
    if (cell->count == kMostPoints) continue;
    cell->sum += p - centre(voxel);
    ++cell->count;
  }
}

VoxelMeanGrid::Cell& VoxelMeanGrid::cellAt(const Voxel& voxel) {
  const std::uint32_t cell = cell_of_.tryEmplace(voxel, static_cast<std::uint32_t>(cells_.size()));
  if (cell == cells_.size()) cells_.emplace_back();
  return cells_[cell];
}

VoxelMeans VoxelMeanGrid::take() {
  VoxelMeans means;
  means.keys.reserve(cells_.size());
  means.points.reserve(cells_.size());
  cell_of_.forEach([&](const Voxel& voxel, std::uint32_t index) {
    const Cell& cell = cells_[index];
    means.keys.push_back(packVoxel(voxel));
    means.points.push_back(centre(voxel) + cell.sum / static_cast<float>(cell.count));
  });
  cell_of_ = {};
  cells_ = {};
  return means;
}

}  // namespace revisit_slam
