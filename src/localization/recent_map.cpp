// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/recent_map.h"

#include <utility>

#include "revisit_slam/mapping/normals.h"
#include "revisit_slam/mapping/viewpoints.h"

namespace revisit_slam {

void RecentMap::insert(const RegisteredScan& scan) {
  constexpr double spacing = 0.9;  // m, between scans whose points are added
  const bool begins = !has_scans_;
  if (begins) travelled_.start(scan.T_odom_base.translation);
  has_scans_ = true;
  travelled_.go(scan.T_odom_base.translation);
  newest_ = scan.id;
  T_odom_newest_ = scan.T_odom_base;
  sensor_base_ = scan.sensor_base;
  if (!begins && travelled() - added_at_ < spacing) return;
  added_at_ = travelled();
  if (open_.T_odom_scan.empty()) {
    open_.begin = travelled();
    open_.scale = scale_.scaleOf(scan.voxel_size);
    grid_ = VoxelMeanGrid(open_.scale * voxel_size_);
    open_.T_odom_slice = scan.T_odom_base;
  }
  open_.T_odom_scan.push_back(scan.T_odom_base);
  open_.stamps.push_back(scan.stamp);
  grid_.insert(scan.points_base, open_.T_odom_slice.inverse() * scan.T_odom_base);
}

void RecentMap::cut() {
  if (open_.T_odom_scan.empty()) return;
  open_.points = grid_.take().points;
  slices_.push_back(std::exchange(open_, {}));
  while (slices_.size() > 1 && slices_[1].begin <= travelled() - length_) slices_.pop_front();
}

double RecentMap::kept() const {
  return slices_.empty() ? 0.0 : travelled() - slices_.front().begin;
}

VoxelMeanGrid RecentMap::joined(double metres) const {
  VoxelMeanGrid grid(newestScale() * voxel_size_);
  for (const Slice& slice : slices_)
    if (slice.begin >= travelled() - metres || &slice == &slices_.back())
      grid.insert(slice.points, T_odom_newest_.inverse() * slice.T_odom_slice);
  return grid;
}

Submap RecentMap::submap(double metres) const {
  Submap submap;
  submap.id.session = submap.local_map.session = newest_.session;
  submap.first_scan = newest_;
  submap.travelled_begin = submap.travelled_end = travelled();
  submap.T_odom_submap = T_odom_newest_;
  for (const Slice& slice : slices_) {
    if (slice.begin < travelled() - metres && &slice != &slices_.back()) continue;
    for (const Pose& T_odom_scan : slice.T_odom_scan)
      submap.T_submap_scan.push_back(T_odom_newest_.inverse() * T_odom_scan);
    submap.stamps.insert(submap.stamps.end(), slice.stamps.begin(), slice.stamps.end());
  }
  VoxelMeans means = joined(metres).take();
  submap.normals = estimateNormals(means);
  submap.points = std::move(means.points);
  submap.scale = newestScale();
  turnToViewpoints(sensor_base_, submap);
  return submap;
}

LocalMap RecentMap::localMap(double metres) const {
  LocalMap map;
  map.id.session = newest_.session;
  map.points = joined(metres).take().points;
  return map;
}

}  // namespace revisit_slam
