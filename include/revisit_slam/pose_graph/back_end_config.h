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

  template <typename Visitor>
  void visit(Visitor& v) {
    solver.visit(v);
    loop_kernel.visit(v);
    v("min_inlier_weight", min_inlier_weight, Range{0.0, 1.0}, "",
      "weight of the robust kernel below which a loop is an outlier; new loops that make more "
      "established loops outliers than they have inliers are rejected. Raise it if wrong loops "
      "are kept; lower it if right loops are rejected");
  }
};

}  // namespace revisit_slam
