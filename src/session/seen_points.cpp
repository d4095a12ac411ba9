// SPDX-License-Identifier: MIT
#include "revisit_slam/session/seen_points.h"

#include <algorithm>

namespace revisit_slam {

SeenPoints seenPoints(const MapUpdate& update, const Pose& T_map_submap, Stamp start) {
  SeenPoints seen;
  const Sightings& sightings = update.sightings;
  if (!update.submap || sightings.lasted.size() != update.detail_submap.size()) return seen;
  const Submap& submap = *update.submap;
  const auto time_of = [&](std::size_t scan) {
    const std::size_t last = submap.stamps.size() - 1;
    return secondsBetween(start, submap.stamps[std::min(scan, last)]);
  };
  std::size_t i = 0;
  for (const PointsSeen& group : sightings.groups) {
    if (group.scan >= submap.T_submap_scan.size()) return {};
    const Pose T_map_scan = T_map_submap * submap.T_submap_scan[group.scan];
    const Eigen::Vector3d sensor_map =
        T_map_scan * Eigen::Vector3d(group.sensor_base.cast<double>());
    seen.groups.push_back({sensor_map.cast<float>(), time_of(group.scan), group.end});
    for (; i < group.end; ++i) {
      const Eigen::Vector3d point = update.detail_submap[i].cast<double>();
      seen.points_map.push_back((T_map_submap * point).cast<float>());
      seen.last_times.push_back(time_of(group.scan + sightings.lasted[i]));
    }
  }
  return seen;
}

}  // namespace revisit_slam
