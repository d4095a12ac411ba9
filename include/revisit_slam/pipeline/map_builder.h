// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include "revisit_slam/core/informed_scan.h"
#include "revisit_slam/mapping/map_hierarchy.h"
#include "revisit_slam/mapping/point_map.h"

namespace revisit_slam {

/// What a scan closed; null where nothing was. A local map comes with the last of its submaps.
struct MapUpdate {
  SubmapPtr submap;
  /// The points of the submap as finely as files have them, in its frame.
  Points detail_submap;
  LocalMapPtr local_map;
};

/// Builds submaps and local maps from the scans of a drive (paper Sec. III-C), and beside them what
/// is written to disk of a submap.
class MapBuilder {
 public:
  explicit MapBuilder(const MappingConfig& config);

  MapUpdate insert(const RegisteredScan& scan);
  /// Closes what is open, if anything.
  MapUpdate closeAll();

 private:
  MapUpdate take(ClosedMaps closed);

  MappingConfig config_;
  MapHierarchy hierarchy_;
  PointMap detail_;
  Pose T_odom_submap_;  // of the open one
  bool open_ = false;
  tbb::task_arena arena_{1};
};

}  // namespace revisit_slam
