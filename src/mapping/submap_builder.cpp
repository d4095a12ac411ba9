// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/submap_builder.h"

#include <utility>

#include "revisit_slam/mapping/normals.h"
#include "revisit_slam/mapping/viewpoints.h"

namespace revisit_slam {

void Travel::start(const Pose& T_odom_base) {
  start_odom_ = T_odom_base.translation;
  distance_.start(start_odom_);
}

void Travel::go(const Pose& T_odom_base) {
  distance_.go(T_odom_base.translation);
}

bool Travel::exceeds(const MapSplitConfig& split, const Pose& T_odom_base) const {
  const Eigen::Vector3d& p = T_odom_base.translation;
  return (p - start_odom_).norm() > split.displacement || distance_.metresTo(p) > split.path_length;
}

void SubmapBuilder::insert(ScanId id, Stamp stamp, const Pose& T_odom_base,
                           const Points& points_base, const SubmapStart& start) {
  drive_.go(T_odom_base);
  if (empty()) {
    submap_.first_scan = id;
    submap_.travelled_begin = drive_.pathLength();
    submap_.unsure_begin = start.unsure;
    submap_.scale = start.scale;
    size_ = start.size;
    sensor_base_ = start.sensor_base;
    submap_.T_odom_submap = T_odom_base;
    grid_ = VoxelMeanGrid(start.scale * voxel_size_);
    travel_.start(T_odom_base);
  }
  travel_.go(T_odom_base);
  submap_.travelled_end = drive_.pathLength();
  const Pose T_submap_scan =
      empty() ? Pose::identity() : submap_.T_odom_submap.inverse() * T_odom_base;
  submap_.T_submap_scan.push_back(T_submap_scan);
  submap_.stamps.push_back(stamp);
  grid_.insert(points_base, T_submap_scan);
}

Submap SubmapBuilder::close(SubmapId id, LocalMapId local_map) {
  VoxelMeans means = grid_.take();
  Submap closed = std::exchange(submap_, {});
  closed.id = id;
  closed.local_map = local_map;
  closed.T_submap_scan.shrink_to_fit();
  closed.stamps.shrink_to_fit();
  closed.normals = estimateNormals(means);
  closed.points = std::move(means.points);
  turnToViewpoints(sensor_base_, closed);
  return closed;
}

}  // namespace revisit_slam
