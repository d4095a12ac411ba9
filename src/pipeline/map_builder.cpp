// SPDX-License-Identifier: MIT
#include "revisit_slam/pipeline/map_builder.h"

#include <utility>

namespace revisit_slam {

MapBuilder::MapBuilder(const MappingConfig& config)
    : config_(config), hierarchy_(config), detail_(config.detail_voxel_size) {}

MapUpdate MapBuilder::insert(const RegisteredScan& scan) {
  MapUpdate update;
  arena_.execute([&] {
    update = take(hierarchy_.insert(scan.id, scan.stamp, scan.T_odom_base, scan.points_base));
  });
  if (!open_) T_odom_submap_ = scan.T_odom_base;
  open_ = true;
  detail_.insert(scan.points_base, T_odom_submap_.inverse() * scan.T_odom_base);
  return update;
}

MapUpdate MapBuilder::closeAll() {
  return arena_.execute([&] { return take(hierarchy_.closeAll()); });
}

MapUpdate MapBuilder::take(ClosedMaps closed) {
  MapUpdate update{std::move(closed.submap), {}, std::move(closed.local_map)};
  if (update.submap) {
    update.detail_submap = std::exchange(detail_, PointMap(config_.detail_voxel_size)).points();
    open_ = false;
  }
  return update;
}

}  // namespace revisit_slam
