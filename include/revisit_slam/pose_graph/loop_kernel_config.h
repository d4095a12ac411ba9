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
      "robust kernel of loop constraints. none: full weight for all; huber: weight falls as "
      "1/residual; cauchy: as 1/residual^2; geman_mcclure: as 1/residual^4");
    v("kernel_scale", kernel_scale, Range{1e-6, 1e9}, "",
      "scale of the robust kernel, a residual sqrt(e' information e); loops with residuals well "
      "above this scale are down-weighted. Raise it if right loops are down-weighted; lower it if "
      "wrong loops bend the map");
  }
};

}  // namespace revisit_slam
