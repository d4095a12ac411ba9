// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/viewpoints.h"

#include <algorithm>

namespace revisit_slam {
namespace {

/// m, between the places that a submap is taken to be seen from.
constexpr double kViewpointSpacing = 1.0;

}  // namespace

void turnToViewpoints(const Eigen::Vector3d& sensor_base, Submap& submap) {
  Points viewpoints;
  for (const Pose& T_submap_scan : submap.T_submap_scan) {
    const Eigen::Vector3f viewpoint = (T_submap_scan * sensor_base).cast<float>();
    if (viewpoints.empty() || (viewpoint - viewpoints.back()).norm() > kViewpointSpacing)
      viewpoints.push_back(viewpoint);
  }
  for (std::size_t i = 0; i < submap.points.size(); ++i) {
    const Eigen::Vector3f& point = submap.points[i];
    const auto nearest =
        std::min_element(viewpoints.begin(), viewpoints.end(),
                         [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                           return (a - point).squaredNorm() < (b - point).squaredNorm();
                         });
    if (submap.normals[i].dot(*nearest - point) < 0.0f) submap.normals[i] = -submap.normals[i];
  }
}

}  // namespace revisit_slam
