// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// What of the occupancy map counts as an obstacle in the 2-D grid, by the height above the ground.
struct ProjectedGridConfig {
  double lowest = 0.5;
  double highest = 2.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("lowest", lowest, Range{0.0, 10.0}, "m",
      "occupied voxels below this height are no obstacles");
    v("highest", highest, Range{0.1, 100.0}, "m",
      "nor are those above: what the robot passes under");
  }
};

/// The occupancy map. Probabilities as OctoMap has them (Hornung et al., 2013), with its defaults.
struct OccupancyConfig {
  bool enabled = true;
  double resolution = 0.5;
  double max_ray = 30.0;
  double scan_spacing = 2.0;
  double hit = 0.7;
  double miss = 0.4;
  double occupied = 0.5;
  double pose_step = 0.5;
  ProjectedGridConfig grid;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled, "build the occupancy map");
    v("resolution", resolution, Range{0.05, 5.0}, "m", "edge of a voxel");
    v("max_ray", max_ray, Range{1.0, 200.0}, "m",
      "rays are followed this far; a point beyond clears the way up to here");
    v("scan_spacing", scan_spacing, Range{0.0, 100.0}, "m",
      "a scan is taken in when the sensor moved this far, or turned by 20 degrees");
    v("hit", hit, Range{0.5, 0.999}, "", "probability of being occupied for a voxel hit once");
    v("miss", miss, Range{0.001, 0.5}, "", "the same for a voxel passed by rays once");
    v("occupied", occupied, Range{0.01, 0.99}, "", "voxels from this probability on are occupied");
    v("pose_step", pose_step, Range{0.0, 10.0}, "voxels",
      "poses of submaps are rounded to steps that move no voxel farther; less re-inserts more "
      "often");
    v.group("grid", grid);
  }
};

}  // namespace revisit_slam
