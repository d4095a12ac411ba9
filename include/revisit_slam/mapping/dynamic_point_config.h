// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Which points of the map are those of something that moved.
struct DynamicPointConfig {
  bool remove = false;
  int rays = 5;
  double share = 0.2;
  double pause = 0.5;
  double ground = 0.15;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("remove", remove,
      "true: points of what moved are in map_dynamic.pcd and out of map.pcd, OctoMap and grid; "
      "false: they are in the map");
    v("rays", rays, Range{1, 1000}, "",
      "smallest number of rays that passed through the voxel of a point, near it, while nothing "
      "was seen "
      "there, for the point to be dynamic. Raise it if points of thin or far objects are removed; "
      "lower it if a sensor with few beams leaves traces");
    v("share", share, Range{0.0, 100.0}, "",
      "smallest ratio of the rays counted by dynamic_points/rays to those that passed while "
      "something was seen there, for the point to be dynamic. Raise it if foliage and fences are "
      "removed; lower it if traces of what moved remain beside what stands");
    v("pause", pause, Range{0.0, 60.0}, "s",
      "time before the first and after the last scan that saw something at a point, in which rays "
      "past it still count as passing while something was there. Raise it if points of thin or far "
      "objects are removed; lower it if what moves fast leaves traces");
    v("ground", ground, Range{0.0, 2.0}, "m",
      "height above the lowest point within two voxels up to which points are never dynamic. Raise "
      "it if ground is removed; lower it if feet and wheels remain");
  }
};

}  // namespace revisit_slam
