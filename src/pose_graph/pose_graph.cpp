// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/pose_graph.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace revisit_slam {
namespace {

bool isFinite(const Pose& T) {
  return std::isfinite(T.translation.squaredNorm()) && T.rotation.coeffs().allFinite();
}

void requireDistinct(FactorNodes nodes, std::size_t known) {
  for (const NodeId& node : nodes)
    if (node.value >= known || std::count(nodes.begin(), nodes.end(), node) > 1)
      throw std::invalid_argument("a factor cannot bind node " + std::to_string(node.value) +
                                  " of " + std::to_string(known) +
                                  (node.value < known ? " twice" : ""));
}

}  // namespace

NodeId PoseGraph::addNode(const Pose& T_map_node) {
  poses_.push_back(T_map_node);
  held_.push_back(false);
  return NodeId{static_cast<std::uint32_t>(poses_.size() - 1)};
}

void PoseGraph::hold(NodeId node) {
  if (node.value >= held_.size())
    throw std::invalid_argument("there is no node " + std::to_string(node.value));
  held_[node.value] = true;
}

bool PoseGraph::isSettled(const Factor& factor) const {
  const FactorNodes nodes = factor.nodes();
  return std::all_of(nodes.begin(), nodes.end(), [&](NodeId node) { return isHeld(node); });
}

FactorId PoseGraph::addFactor(const Measurement& measurement, const RobustKernel& kernel) {
  Factor factor{measurement, kernel};
  requireDistinct(factor.nodes(), poses_.size());
  factors_.push_back(std::move(factor));
  return FactorId{static_cast<std::uint32_t>(factors_.size() - 1)};
}

void PoseGraph::correct(const std::vector<Pose>& solved) {
  if (solved.empty() || solved.size() > poses_.size())
    throw std::invalid_argument("a solution of " + std::to_string(solved.size()) +
                                " poses for a graph of " + std::to_string(poses_.size()));
  const std::size_t last = solved.size() - 1;
  const Pose T_solved_before = solved[last] * poses_[last].inverse();
  std::copy(solved.begin(), solved.end(), poses_.begin());
  for (std::size_t i = solved.size(); i < poses_.size(); ++i)
    poses_[i] = T_solved_before * poses_[i];
}

bool isFinite(const PoseGraph& graph) {
  const auto is_finite = [](const Factor& factor) { return factor.isFinite(); };
  return std::all_of(graph.factors().begin(), graph.factors().end(), is_finite) &&
         std::all_of(graph.poses().begin(), graph.poses().end(),
                     [](const Pose& T) { return isFinite(T); });
}

}  // namespace revisit_slam
