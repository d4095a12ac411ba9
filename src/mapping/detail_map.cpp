// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/detail_map.h"

#include <algorithm>

namespace revisit_slam {
namespace {

/// push_back will not throw then.
template <typename T>
void makeRoomForOne(std::vector<T>& values) {
  if (values.size() == values.capacity()) values.reserve(2 * values.size() + 1);
}

}  // namespace

void DetailMap::insert(const Points& points_base, const Pose& T_submap_base,
                       const Eigen::Vector3d& sensor_base, const std::vector<PointsView>& views,
                       const std::vector<float>& intensities) {
  if (!intensities.empty()) intensities_.resize(points_.size());
  const std::vector<PointsView> all{{sensor_base, points_base.size()}};
  const std::vector<PointsView>& seen = views.empty() ? all : views;
  auto view = seen.begin();
  std::size_t visited = 0;
  std::size_t begin = points_.size();
  const auto endViews = [&] {  // whose points were all visited, or that have none
    for (; view != seen.end() && visited >= view->end; ++view) {
      if (points_.size() > begin)
        sightings_.groups.push_back(
            {scans_, view->sensor_base.cast<float>(), static_cast<std::uint32_t>(points_.size())});
      begin = points_.size();
    }
  };
  forEachInGrid(points_base, T_submap_base, voxels_per_metre_,
                [&](const GridPoints<double>& placed, std::size_t i) {
                  endViews();
                  if (see(placed.voxel(i), placed.point(i)) && !intensities.empty())
                    intensities_.push_back(intensities[visited]);
                  ++visited;
                });
  endViews();
  if (!intensities_.empty()) intensities_.resize(points_.size());
  ++scans_;
}

bool DetailMap::see(const Voxel& voxel, const Eigen::Vector3d& point) {
  makeRoomForOne(points_);
  makeRoomForOne(first_scans_);
  makeRoomForOne(sightings_.lasted);
  const auto next = static_cast<std::uint32_t>(points_.size());
  const std::uint32_t number = point_in_.tryEmplace(voxel, next);
  if (number == next) {
    points_.push_back(point.cast<float>());
    first_scans_.push_back(scans_);
    sightings_.lasted.push_back(0);
    return true;
  }
  const std::uint32_t scans = scans_ - first_scans_[number];
  sightings_.lasted[number] =
      static_cast<std::uint16_t>(std::min<std::uint32_t>(scans, Sightings::kMostScans));
  return false;
}

}  // namespace revisit_slam
