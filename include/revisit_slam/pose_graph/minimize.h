// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

struct MinimizeLimits {
  int max_iterations = 100;
  double function_tolerance = 1e-6;  ///< ends after a step that lowers the cost by a smaller share
};

enum class Minimization { converged, max_iterations, failed };

struct Minimum {
  Minimization outcome = Minimization::failed;
  std::vector<Pose> poses;  ///< the start, if failed
  int iterations = 0;
};

/// The local minimum of graphCost that Levenberg-Marquardt (Ceres, sparse Cholesky) reaches from
/// `start`; the poses of the graph itself only say which nodes are gauges. Redescending
/// kernels have `least_scale` at least; none where that is infinite. One thread: the sums that
/// Ceres makes with more depend on which thread was faster.
Minimum minimize(const PoseGraph& graph, const std::vector<Pose>& start,
                 const MinimizeLimits& limits, double least_scale = 0.0);

}  // namespace revisit_slam
