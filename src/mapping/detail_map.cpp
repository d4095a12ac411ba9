// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/detail_map.h"

#include <algorithm>

namespace revisit_slam {

void DetailMap::insert(const Points& points_base, const Pose& T_submap_base,
                       const Eigen::Vector3d& sensor_base, const std::vector<PointsView>& views) {
  const Eigen::Matrix3d R = T_submap_base.rotationMatrix();
  const std::vector<PointsView> all{{sensor_base, points_base.size()}};
  std::size_t i = 0;
  for (const PointsView& view : views.empty() ? all : views) {
    const std::size_t before = points_.size();
    for (; i < view.end; ++i) see(points_base[i], T_submap_base, R);
    if (points_.size() > before)
      sightings_.groups.push_back(
          {scans_, view.sensor_base.cast<float>(), static_cast<std::uint32_t>(points_.size())});
  }
  ++scans_;
}

void DetailMap::see(const Eigen::Vector3f& point_base, const Pose& T_submap_base,
                    const Eigen::Matrix3d& R) {
  const Eigen::Vector3d point = R * point_base.cast<double>() + T_submap_base.translation;
  const auto [place, is_new] = point_in_.try_emplace(
      packVoxel(voxelOf<double>(point / voxel_size_)), static_cast<std::uint32_t>(points_.size()));
  if (is_new) {
    points_.push_back(point.cast<float>());
    first_scans_.push_back(scans_);
    sightings_.lasted.push_back(0);
    return;
  }
  const std::uint32_t scans = scans_ - first_scans_[place->second];
  sightings_.lasted[place->second] =
      static_cast<std::uint16_t>(std::min<std::uint32_t>(scans, Sightings::kMostScans));
}

}  // namespace revisit_slam
