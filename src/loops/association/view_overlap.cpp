// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/association/view_overlap.h"

#include <algorithm>

namespace revisit_slam {
namespace {

constexpr float kEdge = 3.0f;

std::uint64_t cubeOf(const Eigen::Vector3f& point, float edge) {
  return packVoxel(voxelOf<float>(point / edge));
}

}  // namespace

CoarseView::CoarseView(const Points& points, double scale)
    : edge_(static_cast<float>(scale) * kEdge) {
  for (const Eigen::Vector3f& point : points)
    if (cubes_.insert(cubeOf(point, edge_)).second) points_.push_back(point);
}

double CoarseView::overlap(const CoarseView& source, const CoarseView& target,
                           const Pose& T_target_source) {
  const Eigen::Matrix3f R = T_target_source.rotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_target_source.translation.cast<float>();
  std::size_t shared = 0;
  for (const Eigen::Vector3f& point : source.points_)
    shared += target.cubes_.count(cubeOf(R * point + t, target.edge_));
  const std::size_t larger = std::max(source.points_.size(), target.points_.size());
  return larger == 0 ? 0.0 : static_cast<double>(shared) / static_cast<double>(larger);
}

}  // namespace revisit_slam
