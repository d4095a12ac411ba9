// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Fine registration of two submaps (paper Sec. III-C), coarse to fine: the levels divide the
/// coarsest distances by two until they reach the finest.
struct FineRegistrationConfig {
  double coarsest_distance = 6.0;
  double finest_distance = 0.75;
  int points_per_level = 5000;
  int max_iterations = 30;
  double convergence = 2e-4;
  int min_correspondences = 200;
  double fitness_distance = 0.5;
  double fitness_plane_distance = 0.15;
  double information_voxel_size = 1.5;
  double information_distance = 0.75;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("coarsest_distance", coarsest_distance, Range{0.1, 100.0}, "m",
      "correspondences reach this far at first; the error of the first guess");
    v("finest_distance", finest_distance, Range{0.05, 10.0}, "m",
      "correspondences reach this far at last");
    v("points_per_level", points_per_level, Range{100, 1000000}, "",
      "of more source points a level takes some, evenly over space and directions of normals");
    v("max_iterations", max_iterations, Range{1, 1000}, "", "at each level");
    v("convergence", convergence, Range{1e-9, 1e-1}, "m, rad",
      "the finest level ends when its step [translation; rotation] is shorter");
    v("min_correspondences", min_correspondences, Range{6, 1000000}, "",
      "with fewer matched points there is no result");
    v("fitness_distance", fitness_distance, Range{0.05, 10.0}, "m",
      "the edge of a submap's voxels: one has a counterpart where another is nearer than this…");
    v("fitness_plane_distance", fitness_plane_distance, Range{0.01, 10.0}, "m",
      "… and nearer than this to its plane, where there is one");
    v("information_voxel_size", information_voxel_size, Range{0.1, 10.0}, "m",
      "source points are thinned to this for the information, as scans are for the odometry");
    v("information_distance", information_distance, Range{0.05, 10.0}, "m",
      "tau of the sampled objective");
  }
};

}  // namespace revisit_slam
