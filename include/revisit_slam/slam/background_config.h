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
    v("threads", threads, Range{1, 64}, "",
      "number of threads that search and register loops; results do not depend on it");
    v("niceness", niceness, Range{0, 19}, "",
      "niceness of the threads of maps, loops and optimisation; 19: lowest priority. Raise it if "
      "the odometry drops scans; lower it if corrections come too late");
  }
};

}  // namespace revisit_slam
