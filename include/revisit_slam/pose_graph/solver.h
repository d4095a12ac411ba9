// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/pose_graph.h"
#include "revisit_slam/pose_graph/pose_graph_solution.h"
#include "revisit_slam/pose_graph/solver_config.h"

namespace revisit_slam {

/// Minimises 1/2 sum rho(chi2) over all factors, starting from the poses of the graph. Of every
/// connected part whose absolute factors do not determine where it lies, the first node stays fixed
/// (gauge.h). The result is the same to the last bit for any number of threads.
PoseGraphSolution solve(const PoseGraph& graph, const SolverConfig& config);

}  // namespace revisit_slam
