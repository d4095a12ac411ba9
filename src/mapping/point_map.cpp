// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/point_map.h"

#include "revisit_slam/geometry/grid_points.h"

namespace revisit_slam {

void PointMap::insert(const Points& points_base, const Pose& T_world_base,
                      const std::vector<float>& intensities) {
  if (!intensities.empty()) intensities_.resize(points_.size());
  std::size_t index = 0;
  forEachInGrid(points_base, T_world_base, voxels_per_metre_,
                [&](const GridPoints<double>& placed, std::size_t i) {
                  const std::size_t point = index++;
                  if (!seen_.insert(placed.voxel(i))) return;
                  points_.push_back(placed.point(i).cast<float>());
                  if (!intensities.empty()) intensities_.push_back(intensities[point]);
                });
  if (!intensities_.empty()) intensities_.resize(points_.size());
}

}  // namespace revisit_slam
