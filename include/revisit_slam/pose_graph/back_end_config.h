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
  double pulling_weight = 0.1;

  template <typename Visitor>
  void visit(Visitor& v) {
    solver.visit(v);
    loop_kernel.visit(v);
    v("pulling_weight", pulling_weight, Range{0.0, 1.0}, "",
      "a loop to which the kernel leaves less has no say; where new loops silence more established "
      "ones than they are themselves, they are left out");
  }
};

}  // namespace revisit_slam
