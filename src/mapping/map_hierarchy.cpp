// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/map_hierarchy.h"

#include <memory>
#include <utility>

namespace revisit_slam {

ClosedMaps MapHierarchy::insert(ScanId id, Stamp stamp, const Pose& T_odom_base,
                                const Points& points_base, const SubmapStart& start) {
  next_submap_.session = open_.id.session = id.session;
  ClosedMaps closed;
  if (!builder_.empty()) {
    if (start.after_loss || travel_.exceeds(config_.local_map.scaled(size_), T_odom_base)) {
      closed = closeAll();
    } else if (builder_.travel().exceeds(config_.submap.scaled(builder_.size()), T_odom_base)) {
      closed.submap = closeSubmap();
    }
  }
  const bool begins_local_map = builder_.empty() && open_.submaps.empty();
  if (begins_local_map) {
    travel_.start(T_odom_base);
    size_ = start.size;
    scale_ = start.scale;
    open_.after_loss = start.after_loss;
  }
  travel_.go(T_odom_base);
  builder_.insert(id, stamp, T_odom_base, points_base, start);
  return closed;
}

ClosedMaps MapHierarchy::closeAll() {
  ClosedMaps closed;
  if (!builder_.empty()) closed.submap = closeSubmap();
  if (!open_.submaps.empty()) closed.local_map = closeLocalMap();
  return closed;
}

SubmapPtr MapHierarchy::closeSubmap() {
  auto submap = std::make_shared<const Submap>(builder_.close(next_submap_, open_.id));
  ++next_submap_.value;
  open_.submaps.push_back(submap);
  return submap;
}

LocalMapPtr MapHierarchy::closeLocalMap() {
  const LocalMapId next{open_.id.value + 1, open_.id.session};
  open_.points = unionOfPoints(open_.submaps, scale_ * config_.local_map_voxel_size);
  auto local_map =
      std::make_shared<const LocalMap>(std::exchange(open_, LocalMap{next, {}, {}, false}));
  return local_map;
}

Points unionOfPoints(const std::vector<SubmapPtr>& submaps, double voxel_size) {
  VoxelMeanGrid grid(voxel_size);
  const Pose T_local_odom = submaps.front()->T_odom_submap.inverse();
  for (const SubmapPtr& submap : submaps)
    grid.insert(submap->points, T_local_odom * submap->T_odom_submap);
  return grid.take().points;
}

}  // namespace revisit_slam
