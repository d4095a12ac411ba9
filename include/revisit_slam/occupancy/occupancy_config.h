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
      "height above the ground from which on occupied voxels are obstacles in the 2-D grid. Raise "
      "it if ground or low steps appear as obstacles; lower it if low obstacles are missing");
    v("highest", highest, Range{0.1, 100.0}, "m",
      "height above the ground up to which occupied voxels are obstacles in the 2-D grid. Raise "
      "it if the robot is higher; lower it if the robot passes under what appears as an obstacle");
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
    v("enabled", enabled, "true: the occupancy map is built; false: there is none");
    v("resolution", resolution, Range{0.05, 5.0}, "m",
      "edge of a voxel of the occupancy map. Raise it if the occupancy map takes too much memory; "
      "lower it if the robot navigates in narrow surroundings (0.25 with max_ray 20)");
    v("max_ray", max_ray, Range{1.0, 200.0}, "m",
      "largest length of a ray; along the ray to a point farther away, space is free up to this "
      "distance. Raise it if far obstacles are missing; lower it if the occupancy map takes too "
      "much memory or time");
    v("scan_spacing", scan_spacing, Range{0.0, 100.0}, "m",
      "distance travelled by the sensor from which on the next scan enters the occupancy map; "
      "after a turn by 20 degrees one enters sooner. Raise it if the occupancy map takes too much "
      "time; lower it if moving objects are not cleared");
    v("hit", hit, Range{0.5, 0.999}, "",
      "probability that a voxel is occupied after one scan with a point in the voxel. Raise it if "
      "thin obstacles are missing; lower it if moving objects leave traces");
    v("miss", miss, Range{0.001, 0.5}, "",
      "probability that a voxel is occupied after one scan whose rays pass through the voxel. "
      "Raise it if thin obstacles are cleared; lower it if moving objects leave traces");
    v("occupied", occupied, Range{0.01, 0.99}, "",
      "probability from which on a voxel is occupied; other voxels that were seen are free. Raise "
      "it if moving objects leave traces; lower it if thin obstacles are missing");
    v("pose_step", pose_step, Range{0.0, 10.0}, "voxels",
      "rounding of the poses of submaps in the occupancy map, as the largest displacement of a "
      "voxel: smaller corrections do not rebuild it; 0: no rounding. Raise it if corrections take "
      "too long to reach the occupancy map; lower it if walls of revisited places are blurred");
    v.group("grid", grid);
  }
};

}  // namespace revisit_slam
