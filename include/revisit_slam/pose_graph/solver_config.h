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
    v("max_iterations", max_iterations, Range{1, 10000}, "",
      "largest number of iterations of an optimisation. Raise it if optimisations do not "
      "converge; lower it to bound the time of an optimisation");
    v("function_tolerance", function_tolerance, Range{1e-15, 1e-1}, "",
      "relative decrease of the cost in an iteration below which the optimisation has converged. "
      "Raise it if optimisation takes too long; lower it if poses would change in further "
      "iterations");
    v("threads", threads, Range{1, 64}, "",
      "number of threads of the optimisation; results do not depend on it");
  }
};

}  // namespace revisit_slam
