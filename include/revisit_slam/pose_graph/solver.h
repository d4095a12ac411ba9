// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/pose_graph.h"
#include "revisit_slam/pose_graph/pose_graph_solution.h"
#include "revisit_slam/pose_graph/solver_config.h"

namespace revisit_slam {

/// Minimises 1/2 sum chi2(odometry) + 1/2 sum rho(chi2(loops)) over all poses but the first,
/// starting from the poses of the graph. Of every further part that no constraint connects to the
/// first node, the part's first node stays fixed. The result is the same to the last bit for any
/// number of threads.
PoseGraphSolution solve(const PoseGraph& graph, const SolverConfig& config);

}  // namespace revisit_slam
