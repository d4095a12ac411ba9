// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// When a map is closed: the new scan is farther from the keypose, or came a longer way.
struct MapSplitConfig {
  double displacement;
  double path_length;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("displacement", displacement, Range{1.0, 10000.0}, "m",
      "a scan farther from the keypose begins a new map");
    v("path_length", path_length, Range{1.0, 100000.0}, "m",
      "so does a scan that came a longer way: for walks in circles");
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
  int max_waiting = 300;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled, "false: odometry and information alone; no maps, no loops, no graph");
    v.group("submap", submap);
    v.group("local_map", local_map);
    v("submap_voxel_size", submap_voxel_size, Range{0.05, 5.0}, "m", "nu_sub, edge of a voxel");
    v("local_map_voxel_size", local_map_voxel_size, Range{0.05, 5.0}, "m",
      "nu_loc, edge of a voxel");
    v("detail_voxel_size", detail_voxel_size, Range{0.02, 5.0}, "m",
      "files have one point for each voxel of this edge");
    v("max_waiting", max_waiting, Range{1, 100000}, "scans",
      "scans that may wait live to be mapped; the points of further ones are left out of the maps, "
      "and "
      "counted. Raise it if there is memory, about 1 MB a scan; lower it if there is not");
  }
};

}  // namespace revisit_slam
