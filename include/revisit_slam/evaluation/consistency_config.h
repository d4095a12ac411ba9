// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Where a place counts as visited again, and how its maps are compared.
struct ConsistencyConfig {
  double cell_size = 20.0;
  double min_time_between = 30.0;
  double max_height_difference = 2.5;
  double radius = 30.0;
  double voxel_size = 0.25;
  double max_distance = 1.0;
  double thickness_edge = 1.0;
  int kept_cells = 3;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("cell_size", cell_size, Range{1.0, 1000.0}, "m",
      "edge of a cell of the grid over the trajectory");
    v("min_time_between", min_time_between, Range{0.0, 1e6}, "s",
      "a cell is visited again when the trajectory was out of it for so long");
    v("max_height_difference", max_height_difference, Range{0.0, 1e6}, "m",
      "visits whose mean heights differ by more are of different floors and are not compared");
    v("radius", radius, Range{1.0, 1000.0}, "m",
      "a local map holds points so near to where its cell was first entered");
    v("voxel_size", voxel_size, Range{0.02, 5.0}, "m",
      "edge of the voxels whose means are compared");
    v("max_distance", max_distance, Range{0.01, 10.0}, "m", "points farther apart are no pair");
    v("thickness_edge", thickness_edge, Range{0.1, 10.0}, "m",
      "edge of the cubes in which the thickness of surfaces is measured");
    v("kept_cells", kept_cells, Range{0, 1000}, "",
      "cells with the largest RMS whose maps are kept");
  }
};

}  // namespace revisit_slam
