// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/types/pose.h"

namespace revisit_slam {

enum class SolveOutcome {
  converged,
  max_iterations,  ///< better than before, but not yet at the minimum
  failed,          ///< numbers that are not finite, or no step possible; poses are as given
  no_loops,        ///< odometry alone, nothing to correct; poses are as given
};

/// "converged", "max_iterations", …
const char* nameOf(SolveOutcome outcome);

/// What became of a factor; chi2 = e^T information e.
struct FactorResidual {
  double chi2_before = 0.0, chi2_after = 0.0;
  double weight = 1.0;  ///< of its kernel after the solve, 0 … 1; near 0 for a rejected loop
};

/// Costs are 1/2 sum rho(chi2) over all factors.
struct PoseGraphSolution {
  SolveOutcome outcome = SolveOutcome::failed;
  std::vector<Pose> poses;              ///< T_map_node, by NodeId
  std::vector<FactorResidual> factors;  ///< by FactorId
  double initial_cost = 0.0, final_cost = 0.0;
  int iterations = 0;         ///< on the whole graph
  int coarse_iterations = 0;  ///< before, on the reduced graph or with a widened kernel
  double seconds = 0.0;

  bool usable() const {
    return outcome == SolveOutcome::converged || outcome == SolveOutcome::max_iterations;
  }
};

}  // namespace revisit_slam
