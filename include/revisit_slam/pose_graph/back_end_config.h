// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/loop_kernel_config.h"
#include "revisit_slam/pose_graph/solver_config.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The pose graph as it grows (paper Sec. III-D).
struct BackEndConfig {
  SolverConfig solver;
  LoopKernelConfig loop_kernel;
  double min_inlier_weight = 0.1;
  double drift = 0.007;
  double turn_drift = 2e-4;
  bool freeze_map = false;

  template <typename Visitor>
  void visit(Visitor& v) {
    solver.visit(v);
    loop_kernel.visit(v);
    v("min_inlier_weight", min_inlier_weight, Range{0.0, 1.0}, "",
      "weight of the robust kernel below which a loop is an outlier; new loops that make more "
      "established loops outliers than they have inliers are rejected. Raise it if wrong loops "
      "are kept; lower it if right loops are rejected");
    v("drift", drift, Range{0.0, 1.0}, "",
      "standard deviation that is added to odometry edges, in metres for each metre travelled, "
      "where positions of GNSS or directions of gravity are used; for the best constrained "
      "direction, and proportionally more in the others. Raise it if the map does not follow good "
      "positions; lower it if their noise bends the map");
    v("turn_drift", turn_drift, Range{0.0, 1.0}, "rad/m",
      "standard deviation that is added to the rotation of odometry edges, in radians for each "
      "metre travelled, where positions of GNSS or directions of gravity are used; for the best "
      "constrained axis, and proportionally more about the others. Raise it if the map does not "
      "follow good positions or directions; lower it if their noise bends the map");
    v("freeze_map", freeze_map,
      "of a drive that goes on from a saved map. true: the poses of that map stay as they are; "
      "false: the optimisation may move both");
  }
};

}  // namespace revisit_slam
