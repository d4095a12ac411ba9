// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Optimisation of the pose graph (paper Sec. III-D).
struct SolverConfig {
  int max_iterations = 100;
  double function_tolerance = 1e-6;
  int threads = 2;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_iterations", max_iterations, Range{1, 10000}, "", "steps of the optimiser at most");
    v("function_tolerance", function_tolerance, Range{1e-15, 1e-1}, "",
      "it ends after a step that lowers the cost by a smaller share");
    v("threads", threads, Range{1, 64}, "",
      "threads of the optimiser; results do not depend on it");
  }
};

}  // namespace revisit_slam
