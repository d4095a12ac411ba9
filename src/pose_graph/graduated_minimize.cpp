// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/graduated_minimize.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

/// Factor between two squared scales, and how far each is minimised before the next.
constexpr double kNarrowing = 2.0;
constexpr MinimizeLimits kBetween{4, 1e-3};
constexpr double kNoKernel = std::numeric_limits<double>::infinity();

/// Of the factors with redescending kernels.
double largestChi2(const PoseGraph& graph, const std::vector<Pose>& poses) {
  double largest = 0.0;
  for (const Factor& factor : graph.factors())
    if (factor.kernel.isRedescending()) largest = std::max(largest, factor.chi2(poses));
  return largest;
}

double smallestScale(const PoseGraph& graph) {
  double smallest = kNoKernel;
  for (const Factor& factor : graph.factors())
    if (factor.kernel.isRedescending()) smallest = std::min(smallest, factor.kernel.scale);
  return smallest;
}

Minimum minimizeNarrowing(const PoseGraph& graph, const std::vector<Pose>& start,
                          const MinimizeLimits& limits) {
  Minimum minimum = minimize(graph, start, limits, kNoKernel);
  double scale = std::sqrt(2.0 * largestChi2(graph, minimum.poses));
  int iterations = minimum.iterations;
  for (; scale > smallestScale(graph); scale /= std::sqrt(kNarrowing)) {
    minimum = minimize(graph, minimum.poses, kBetween, scale);
    iterations += minimum.iterations;
  }
  minimum = minimize(graph, minimum.poses, limits);
  minimum.iterations += iterations;
  return minimum;
}

}  // namespace

Minimum graduatedMinimize(const PoseGraph& graph, const std::vector<Pose>& start,
                          const MinimizeLimits& limits) {
  Minimum straight = minimize(graph, start, limits);
  if (!hasRedescendingKernel(graph)) return straight;
  Minimum narrowed = minimizeNarrowing(graph, start, limits);
  narrowed.iterations += straight.iterations;
  straight.iterations = narrowed.iterations;
  const bool better = graphCost(graph, narrowed.poses) <= graphCost(graph, straight.poses);
  return better ? narrowed : straight;
}

bool hasRedescendingKernel(const PoseGraph& graph) {
  return std::any_of(graph.factors().begin(), graph.factors().end(),
                     [](const Factor& factor) { return factor.kernel.isRedescending(); });
}

}  // namespace revisit_slam
