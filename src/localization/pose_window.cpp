// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/pose_window.h"

#include "revisit_slam/pose_graph/solver.h"

namespace revisit_slam {
namespace {

/// A base that stands for days goes nowhere.
constexpr std::size_t kMostScans = 5000;

}  // namespace

void PoseWindow::fix(const Pose& T_map_base, const Matrix6& information) {
  nodes_.back().T_map_base = T_map_base;
  nodes_.back().information = information;
}

void PoseWindow::clearFixes() {
  for (Node& node : nodes_) node.T_map_base.reset();
}

void PoseWindow::shorten(double metres) {
  while (nodes_.size() > kMostScans) nodes_.pop_front();
  double travelled = 0.0;
  for (std::size_t i = nodes_.size(); i-- > 1;) {
    travelled +=
        (nodes_[i].node.T_odom_base.translation - nodes_[i - 1].node.T_odom_base.translation)
            .norm();
    if (travelled <= metres) continue;
    nodes_.erase(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

/// The map is the first node, which stays fixed. Scans after the last fix follow it as the odometry
/// has them.
std::optional<Pose> PoseWindow::solve() const {
  const Node* last = nullptr;
  for (const Node& node : nodes_)
    if (node.T_map_base) last = &node;
  if (!last) return std::nullopt;
  const Pose T_map_odom = *last->T_map_base * last->node.T_odom_base.inverse();
  PoseGraph graph;
  const NodeId map = graph.addNode(Pose::identity());
  NodeId id = map;
  const Node* previous = nullptr;
  for (const Node& node : nodes_) {
    const NodeId before = id;
    id = graph.addNode(T_map_odom * node.node.T_odom_base);
    if (previous)
      graph.addFactor(
          RelativePoseFactor{{before, id},
                             previous->node.T_odom_base.inverse() * node.node.T_odom_base,
                             node.node.information});
    if (node.T_map_base)
      graph.addFactor(RelativePoseFactor{{map, id}, *node.T_map_base, node.information},
                      config_.loop_kernel.value());
    previous = &node;
    if (&node == last) break;
  }
  const PoseGraphSolution solution = revisit_slam::solve(graph, config_.solver);
  if (!solution.usable()) return std::nullopt;
  return solution.poses.back() * last->node.T_odom_base.inverse();
}

}  // namespace revisit_slam
