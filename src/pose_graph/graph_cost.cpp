// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/graph_cost.h"

#include <numeric>

#include "revisit_slam/pose_graph/relative_pose_cost.h"

namespace revisit_slam {

std::vector<double> chi2Of(const std::vector<Constraint>& constraints,
                           const std::vector<Pose>& poses) {
  std::vector<double> result;
  result.reserve(constraints.size());
  for (const Constraint& constraint : constraints)
    result.push_back(chi2(constraint, poses[constraint.from.value], poses[constraint.to.value]));
  return result;
}

double graphCost(const PoseGraph& graph, const std::vector<Pose>& poses,
                 const RobustKernel& kernel) {
  const std::vector<double> odometry = chi2Of(graph.odometry(), poses);
  double sum = std::accumulate(odometry.begin(), odometry.end(), 0.0);
  const auto loss = makeLoss(kernel);
  double rho[3] = {};
  for (const double chi2 : chi2Of(graph.loops(), poses)) {
    if (loss) loss->Evaluate(chi2, rho);
    sum += loss ? rho[0] : chi2;
  }
  return 0.5 * sum;
}

double weightOf(const RobustKernel& kernel, double chi2) {
  const auto loss = makeLoss(kernel);
  if (!loss) return 1.0;
  double rho[3] = {};
  loss->Evaluate(chi2, rho);
  return rho[1];
}

}  // namespace revisit_slam
