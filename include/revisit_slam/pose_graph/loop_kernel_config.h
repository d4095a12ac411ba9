// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/pose_graph/robust_kernel.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The robust kernel of loop constraints (paper Sec. III-D).
struct LoopKernelConfig {
  std::string kernel = "cauchy";
  double kernel_scale = 5.0;

  RobustKernel value() const { return {kernelTypeOf(kernel), kernel_scale}; }

  template <typename Visitor>
  void visit(Visitor& v) {
    v("kernel", kernel, Choices{"none", "huber", "cauchy", "geman_mcclure"}, "",
      "robust kernel of loop constraints");
    v("kernel_scale", kernel_scale, Range{1e-6, 1e9}, "",
      "loop residuals sqrt(e' information e) well beyond it lose their weight");
  }
};

}  // namespace revisit_slam
