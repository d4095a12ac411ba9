// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/voxel_mean_grid.h"

#include <limits>

#include "revisit_slam/geometry/grid_points.h"

namespace revisit_slam {
namespace {

const Voxel kNowhere = Voxel::Constant(std::numeric_limits<int>::max());

}  // namespace

void VoxelMeanGrid::insert(const Points& points, const Pose& T_grid_points) {
  Voxel previous = kNowhere;
  Cell* cell = nullptr;
  forEachInGrid(points, T_grid_points, 1.0f / edge_,
                [&](const GridPoints<float>& placed, std::size_t i) {
                  const Voxel voxel = placed.voxel(i);
                  if (voxel != previous) cell = &cellAt(voxel);
                  previous = voxel;
                  if (cell->count == kMostPoints) return;
                  cell->sum += placed.point(i) - centre(voxel);
                  ++cell->count;
                });
}

VoxelMeanGrid::Cell& VoxelMeanGrid::cellAt(const Voxel& voxel) {
  const std::size_t next = voxels();
  if (next == cells_.size()) cells_.emplace_back();  // before it has its number: this may throw
  return cells_[cell_of_.tryEmplace(voxel, static_cast<std::uint32_t>(next))];
}

VoxelMeans VoxelMeanGrid::take() {
  VoxelMeans means;
  means.keys.reserve(voxels());
  means.points.reserve(voxels());
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
