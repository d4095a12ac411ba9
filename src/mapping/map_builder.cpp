// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/map_builder.h"

#include <utility>

namespace revisit_slam {

MapBuilder::MapBuilder(const MappingConfig& mapping, const OccupancyConfig& occupancy)
    : detail_voxel_size_(mapping.detail_voxel_size),
      with_occupancy_(occupancy.enabled),
      hierarchy_(mapping),
      detail_(mapping.detail_voxel_size),
      occupancy_(occupancy) {}

MapUpdate MapBuilder::insert(const RegisteredScan& scan, const SubmapStart& start) {
  MapUpdate update;
  arena_.execute([&] {
    update =
        take(hierarchy_.insert(scan.id, scan.stamp, scan.T_odom_base, scan.points_base, start));
  });
  if (!open_) T_odom_submap_ = scan.T_odom_base;
  open_ = true;
  const Pose T_submap_base = T_odom_submap_.inverse() * scan.T_odom_base;
  detail_.insert(scan.points_base, T_submap_base, scan.sensor_base, scan.views, scan.intensities);
  if (with_occupancy_) {
    occupancy_.insert(scan.points_base, T_submap_base, scan.sensor_base, scan.views);
    const Pose from = T_odom_last_.value_or(scan.T_odom_base);
    occupancy_.drive(T_odom_submap_.inverse() * from, T_submap_base, scan.sensor_base);
  }
  T_odom_last_.reset();
  if (scan.verdict != PoseVerdict::lost) T_odom_last_ = scan.T_odom_base;
  return update;
}

MapUpdate MapBuilder::closeAll() {
  return arena_.execute([&] { return take(hierarchy_.closeAll()); });
}

MapUpdate MapBuilder::take(ClosedMaps closed) {
  MapUpdate update;
  update.submap = std::move(closed.submap);
  update.local_map = std::move(closed.local_map);
  if (!update.submap) return update;
  const DetailMap detail = std::exchange(detail_, DetailMap(detail_voxel_size_));
  update.detail_submap = detail.points();
  update.intensities = detail.intensities();
  if (!update.intensities.empty()) update.intensities.resize(update.detail_submap.size());
  update.sightings = detail.sightings();
  if (with_occupancy_) update.occupancy = occupancy_.close();
  open_ = false;
  return update;
}

}  // namespace revisit_slam
