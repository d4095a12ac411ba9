// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

/// chi2 = e^T information e of every factor at these poses, by FactorId.
std::vector<double> chi2Of(const PoseGraph& graph, const std::vector<Pose>& poses);

/// 1/2 sum rho(chi2) over all factors, each with its kernel.
double graphCost(const PoseGraph& graph, const std::vector<double>& chi2);
double graphCost(const PoseGraph& graph, const std::vector<Pose>& poses);

/// The share rho'(chi2) of its information that a factor keeps, 0 … 1.
double weightOf(const RobustKernel& kernel, double chi2);

}  // namespace revisit_slam
