// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// What loops and optimisation may take from the machine, beside the odometry. Results do not
/// depend on it.
struct BackgroundConfig {
  int threads = 1;
  int niceness = 10;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("threads", threads, Range{1, 64}, "", "threads of loop closure; results do not depend on it");
    v("niceness", niceness, Range{0, 19}, "",
      "how far maps, loops and optimisation stand back for the odometry; 19: the farthest");
  }
};

}  // namespace revisit_slam
