// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <memory>
#include <optional>

#include "revisit_slam/mapping/detail_map.h"
#include "revisit_slam/mapping/map_hierarchy.h"
#include "revisit_slam/mapping/submap_library.h"
#include "revisit_slam/occupancy/occupancy_builder.h"
#include "revisit_slam/types/informed_scan.h"

namespace revisit_slam {

/// What a scan closed; null where nothing was. A local map comes with the last of its submaps.
struct MapUpdate {
  SubmapPtr submap;
  /// The points of the submap as finely as files have them, in its frame.
  Points detail_submap;
  std::vector<float> intensities;  ///< of these points; none: the sensor has none
  Sightings sightings;             ///< of these points; none: not known
  SubmapOccupancyPtr occupancy;    ///< of the submap; null where occupancy is switched off
  LocalMapPtr local_map;
  /// That the submap is in, and is told when it is on disk; null: none.
  std::shared_ptr<SubmapLibrary> library = nullptr;
};

using MapUpdatePtr = std::shared_ptr<const MapUpdate>;

/// Builds submaps and local maps from the scans of a drive (paper Sec. III-C), and beside them the
/// occupancy of each submap and what is written to disk of it.
class MapBuilder {
 public:
  MapBuilder(const MappingConfig& mapping, const OccupancyConfig& occupancy);

  MapUpdate insert(const RegisteredScan& scan, const SubmapStart& start = {});
  /// Closes what is open, if anything.
  MapUpdate closeAll();

 private:
  MapUpdate take(ClosedMaps closed);

  double detail_voxel_size_;
  bool with_occupancy_;
  MapHierarchy hierarchy_;
  DetailMap detail_;
  OccupancyBuilder occupancy_;
  Pose T_odom_submap_;               // of the open one
  std::optional<Pose> T_odom_last_;  // of the scan before; none: its pose was lost
  bool open_ = false;
  tbb::task_arena arena_{1};
};

}  // namespace revisit_slam
