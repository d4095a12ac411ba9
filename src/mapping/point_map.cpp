// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/point_map.h"

#include "revisit_slam/geometry/grid_points.h"

namespace revisit_slam {

void PointMap::insert(const Points& points_base, const Pose& T_world_base) {
  forEachInGrid(points_base, T_world_base, voxels_per_metre_,
                [&](const GridPoints<double>& placed, std::size_t i) {
                  if (seen_.insert(placed.voxel(i)))
                    points_.push_back(placed.point(i).cast<float>());
                });
}

}  // namespace revisit_slam
