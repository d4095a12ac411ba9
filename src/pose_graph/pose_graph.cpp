// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/pose_graph.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace revisit_slam {
namespace {

bool isFinite(const Pose& T) {
  return std::isfinite(T.translation.squaredNorm()) && T.rotation.coeffs().allFinite();
}

bool areFinite(const std::vector<Constraint>& constraints) {
  return std::all_of(constraints.begin(), constraints.end(), [](const Constraint& constraint) {
    return isFinite(constraint.T_from_to) && std::isfinite(constraint.information.squaredNorm());
  });
}

}  // namespace

ScanId PoseGraph::addNode(const Pose& T_map_scan) {
  poses_.push_back(T_map_scan);
  return ScanId{static_cast<std::uint32_t>(poses_.size() - 1)};
}

void PoseGraph::addOdometry(const Constraint& constraint) {
  requireNodesOf(constraint);
  odometry_.push_back(constraint);
}

LoopId PoseGraph::addLoop(const Constraint& constraint) {
  requireNodesOf(constraint);
  loops_.push_back(constraint);
  return LoopId{static_cast<std::uint32_t>(loops_.size() - 1)};
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

void PoseGraph::requireNodesOf(const Constraint& constraint) const {
  const auto [from, to] = std::pair(constraint.from.value, constraint.to.value);
  if (from == to || std::max(from, to) >= poses_.size())
    throw std::invalid_argument("constraint from node " + std::to_string(from) + " to node " +
                                std::to_string(to) + " of " + std::to_string(poses_.size()));
}

bool isFinite(const PoseGraph& graph) {
  return areFinite(graph.odometry()) && areFinite(graph.loops()) &&
         std::all_of(graph.poses().begin(), graph.poses().end(),
                     [](const Pose& T) { return isFinite(T); });
}

}  // namespace revisit_slam
