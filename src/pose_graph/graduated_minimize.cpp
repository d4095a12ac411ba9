// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/graduated_minimize.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

/// Factor between two squared scales, and how far each is minimised before the next.
constexpr double kNarrowing = 2.0;
constexpr MinimizeLimits kBetween{4, 1e-3};

double largestLoopChi2(const PoseGraph& graph, const std::vector<Pose>& poses) {
  const std::vector<double> chi2 = chi2Of(graph.loops(), poses);
  return chi2.empty() ? 0.0 : *std::max_element(chi2.begin(), chi2.end());
}

Minimum minimizeNarrowing(const PoseGraph& graph, const std::vector<Pose>& start,
                          const RobustKernel& kernel, const MinimizeLimits& limits) {
  Minimum minimum = minimize(graph, start, RobustKernel{}, limits);
  RobustKernel wide = kernel;
  wide.scale = std::sqrt(2.0 * largestLoopChi2(graph, minimum.poses));
  int iterations = minimum.iterations;
  for (; wide.scale > kernel.scale; wide.scale /= std::sqrt(kNarrowing)) {
    minimum = minimize(graph, minimum.poses, wide, kBetween);
    iterations += minimum.iterations;
  }
  minimum = minimize(graph, minimum.poses, kernel, limits);
  minimum.iterations += iterations;
  return minimum;
}

}  // namespace

Minimum graduatedMinimize(const PoseGraph& graph, const std::vector<Pose>& start,
                          const RobustKernel& kernel, const MinimizeLimits& limits) {
  Minimum straight = minimize(graph, start, kernel, limits);
  if (!kernel.forgetsFarLoops()) return straight;
  Minimum narrowed = minimizeNarrowing(graph, start, kernel, limits);
  narrowed.iterations += straight.iterations;
  straight.iterations = narrowed.iterations;
  const bool better =
      graphCost(graph, narrowed.poses, kernel) <= graphCost(graph, straight.poses, kernel);
  return better ? narrowed : straight;
}

}  // namespace revisit_slam
