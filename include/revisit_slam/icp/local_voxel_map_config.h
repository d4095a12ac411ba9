// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The local map that scans are registered to.
struct LocalVoxelMapConfig {
  double voxel_size = 0.7;
  int max_points_per_voxel = 20;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("voxel_size", voxel_size, Range{0.02, 20.0}, "m",
      "edge of a voxel of the odometry's map, the largest with adaptive_voxel_size; about a "
      "hundredth of max_range. Raise it if registration takes too long; lower it if the "
      "surroundings are narrow");
    v("max_points_per_voxel", max_points_per_voxel, Range{1, 100}, "",
      "largest number of points kept in a voxel. Raise it if details are to count; lower it if "
      "registration takes too long");
  }
};

}  // namespace revisit_slam
