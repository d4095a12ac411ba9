// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Optimisation of the pose graph (paper Sec. III-D).
struct SolverConfig {
  int max_iterations = 100;
  double function_tolerance = 1e-6;
  int threads = 2;
  std::string kernel = "cauchy";
  double kernel_scale = 5.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_iterations", max_iterations, Range{1, 10000}, "", "steps of the optimiser at most");
    v("function_tolerance", function_tolerance, Range{1e-15, 1e-1}, "",
      "it ends after a step that lowers the cost by a smaller share");
    v("threads", threads, Range{1, 64}, "",
      "threads of the optimiser; results do not depend on it");
    v("kernel", kernel, Choices{"none", "huber", "cauchy", "geman_mcclure"}, "",
      "robust kernel of loop constraints");
    v("kernel_scale", kernel_scale, Range{1e-6, 1e9}, "",
      "loop residuals sqrt(e' information e) well beyond it lose their weight");
  }
};

}  // namespace revisit_slam
