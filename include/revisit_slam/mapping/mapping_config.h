// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "revisit_slam/mapping/dynamic_point_config.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// When a map is closed: the new scan is farther from the keypose, or came a longer way.
struct MapSplitConfig {
  double displacement;
  double path_length;

  /// For surroundings that are narrower by this factor.
  MapSplitConfig scaled(double scale) const { return {scale * displacement, scale * path_length}; }

  template <typename Visitor>
  void visit(Visitor& v) {
    v("displacement", displacement, Range{1.0, 10000.0}, "m",
      "largest distance of a scan from the keypose (the first scan) of its map; a scan farther "
      "away begins a new map. Raise it if maps have too little structure to be matched; lower it "
      "if drift bends maps");
    v("path_length", path_length, Range{1.0, 100000.0}, "m",
      "largest travelled distance from the keypose within a map; a scan beyond this distance "
      "begins a new map. Raise it if winding routes give many small maps; lower it if drift bends "
      "maps where the robot goes in circles");
  }
};

/// The hierarchy of maps (paper Sec. III-C). Path lengths are ours: on a straight road they never
/// act.
struct MappingConfig {
  bool enabled = true;
  MapSplitConfig submap{25.0, 50.0};
  MapSplitConfig local_map{100.0, 200.0};
  double submap_voxel_size = 0.5;
  double local_map_voxel_size = 0.5;
  double detail_voxel_size = 0.25;
  bool follow_scale = true;
  double rest_interval = 2.0;
  int max_waiting = 300;
  int cache_mb = 256;
  DynamicPointConfig dynamic_points;

  std::size_t cacheBytes() const { return static_cast<std::size_t>(cache_mb) * 1'000'000; }

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled,
      "true: maps, loops and pose graph; false: odometry and information alone");
    v.group("submap", submap);
    v.group("local_map", local_map);
    v("submap_voxel_size", submap_voxel_size, Range{0.05, 5.0}, "m",
      "nu_sub, edge of a voxel of the submaps, which loops are registered with. Raise it if "
      "registrations of loops take too long; lower it if the surroundings are narrow");
    v("local_map_voxel_size", local_map_voxel_size, Range{0.05, 5.0}, "m",
      "nu_loc, edge of a voxel of the local maps, which places are recognised by. Raise it if "
      "local maps take too much memory; lower it if loops/recognition/image/resolution is lowered");
    v("detail_voxel_size", detail_voxel_size, Range{0.02, 5.0}, "m",
      "edge of a voxel of the point clouds in files, which have one point for each voxel. Raise "
      "it if files are too large; lower it if files should show finer detail");
    v("follow_scale", follow_scale,
      "true: where the odometry has taken smaller voxels than configured, as in rooms, submaps and "
      "local maps are smaller by the same factor, and below half their size so are their voxels; "
      "false: all have the same size");
    v("rest_interval", rest_interval, Range{0.0, 3600.0}, "s",
      "while the base stands still, time between scans that become part of maps, graph and "
      "trajectory.tum; odometry.tum has them all; 0: every scan. Raise it if a robot is parked for "
      "days; lower it if every scan needs a corrected pose");
    v("max_waiting", max_waiting, Range{1, 100000}, "scans",
      "largest number of scans that may wait live to be mapped; the points of further ones are "
      "left out of the maps, and counted. Raise it if points are left out and memory is free "
      "(about 1 MB a scan); lower it if memory is short");
    v("cache_mb", cache_mb, Range{1, 100000}, "MB",
      "memory for closed submaps that are on disk; those that were not used for the longest time "
      "are read back from the folder of the session when they are needed. Results do not depend on "
      "it. Raise it if searches for loops or rviz read the disk much; lower it if memory is short");
    v.group("dynamic_points", dynamic_points);
  }
};

}  // namespace revisit_slam
