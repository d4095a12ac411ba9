// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"
#include "revisit_slam/pose_graph/robust_kernel.h"

namespace revisit_slam {

/// chi2 = e^T information e of every constraint at these poses.
std::vector<double> chi2Of(const std::vector<Constraint>& constraints,
                           const std::vector<Pose>& poses);

/// 1/2 sum chi2(odometry) + 1/2 sum rho(chi2(loops)).
double graphCost(const PoseGraph& graph, const std::vector<Pose>& poses,
                 const RobustKernel& kernel);

/// The share rho'(chi2) of its information with which a loop pulls, 0 … 1.
double weightOf(const RobustKernel& kernel, double chi2);

}  // namespace revisit_slam
