// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

struct Rho {
  double value, slope;
};

Rho evaluate(const RobustKernel& kernel, double chi2) {
  const auto loss = makeLoss(kernel);
  if (!loss) return {chi2, 1.0};
  double rho[3] = {};
  loss->Evaluate(chi2, rho);
  return {rho[0], rho[1]};
}

}  // namespace

std::vector<double> chi2Of(const PoseGraph& graph, const std::vector<Pose>& poses) {
  std::vector<double> result;
  result.reserve(graph.factors().size());
  for (const Factor& factor : graph.factors()) result.push_back(factor.chi2(poses));
  return result;
}

double graphCost(const PoseGraph& graph, const std::vector<double>& chi2) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chi2.size(); ++i)
    sum += evaluate(graph.factors()[i].kernel, chi2[i]).value;
  return 0.5 * sum;
}

double graphCost(const PoseGraph& graph, const std::vector<Pose>& poses) {
  return graphCost(graph, chi2Of(graph, poses));
}

double weightOf(const RobustKernel& kernel, double chi2) {
  return evaluate(kernel, chi2).slope;
}

}  // namespace revisit_slam
