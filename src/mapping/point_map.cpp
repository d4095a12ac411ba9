// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/point_map.h"

namespace revisit_slam {

void PointMap::insert(const Points& points_base, const Pose& T_world_base) {
  const Eigen::Matrix3d R = T_world_base.rotationMatrix();
  for (const Eigen::Vector3f& point_base : points_base) {
    const Eigen::Vector3d point = R * point_base.cast<double>() + T_world_base.translation;
    if (seen_.insert(voxelOf<double>(point * voxels_per_metre_)))
      points_.push_back(point.cast<float>());
  }
}

}  // namespace revisit_slam
