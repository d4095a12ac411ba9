// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gauge.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "revisit_slam/pose_graph/information_root.h"

namespace revisit_slam {
namespace {

/// Share of the largest eigenvalue below which a translation counts as not measured.
constexpr double kWeakest = 1e-9;
constexpr double kLooseRotation = 0.1;  // rad

/// Disjoint sets of nodes, each known by its smallest node.
class ConnectedParts {
 public:
  explicit ConnectedParts(std::size_t nodes) : parent_(nodes) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t firstOf(std::uint32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }

  void connect(FactorNodes nodes) {
    for (const NodeId& node : nodes) {
      const std::uint32_t a = firstOf(nodes.begin()->value), b = firstOf(node.value);
      parent_[std::max(a, b)] = std::min(a, b);
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// What is known of where a part lies: of its motions as a whole, written as right perturbations of
/// one of its poses.
class AbsoluteInformation {
 public:
  /// Of the node of an absolute factor, J^T J by right perturbations of its pose.
  void add(const Pose& T_map_node, const Matrix6& information) {
    if (!T_map_part_) T_map_part_ = T_map_node;
    const Matrix6 A = adjoint(T_map_node.inverse() * *T_map_part_);
    information_ += A.transpose() * information * A;
  }

  bool determinesThePart() const {
    using Eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;
    const Eigen::Matrix3d translation = information_.topLeftCorner<3, 3>();
    const Eigen::Vector3d known = Eigenvalues(translation, Eigen::EigenvaluesOnly).eigenvalues();
    if (!(known[0] > kWeakest * known[2])) return false;
    const Eigen::Matrix3d rotation = information_.bottomRightCorner<3, 3>() -
                                     information_.bottomLeftCorner<3, 3>() * translation.inverse() *
                                         information_.topRightCorner<3, 3>();
    const Eigen::Vector3d held = Eigenvalues(rotation, Eigen::EigenvaluesOnly).eigenvalues();
    return held[0] > 1.0 / (kLooseRotation * kLooseRotation);
  }

 private:
  std::optional<Pose> T_map_part_;
  Matrix6 information_ = Matrix6::Zero();
};

/// J^T J of an absolute factor, by right perturbations of the pose of its node.
Matrix6 informationOfNode(const Factor& factor, const std::vector<Pose>& poses) {
  return std::visit(
      [&](const auto& measured) -> Matrix6 {
        const auto U = informationRoot(measured.information);
        const auto J = measured.linearized(posesOf(measured, poses), U).jacobians[0];
        return J.transpose() * J;
      },
      factor.measurement);
}

/// The first nodes of the parts that held nodes or absolute factors determine.
std::set<std::uint32_t> determinedParts(const PoseGraph& graph, ConnectedParts& parts) {
  std::map<std::uint32_t, AbsoluteInformation> known;
  for (const Factor& factor : graph.factors()) {
    if (factor.nodes().size() > 1) continue;
    const std::uint32_t node = factor.nodes().begin()->value;
    known[parts.firstOf(node)].add(graph.poses()[node], informationOfNode(factor, graph.poses()));
  }
  std::set<std::uint32_t> determined;
  for (const auto& [first, information] : known)
    if (information.determinesThePart()) determined.insert(first);
  for (std::uint32_t i = 0; i < graph.poses().size(); ++i)
    if (graph.isHeld({i})) determined.insert(parts.firstOf(i));
  return determined;
}

}  // namespace

std::vector<NodeId> gaugeNodes(const PoseGraph& graph) {
  ConnectedParts parts(graph.poses().size());
  for (const Factor& factor : graph.factors()) parts.connect(factor.nodes());
  const std::set<std::uint32_t> determined = determinedParts(graph, parts);
  std::vector<NodeId> gauges;
  for (std::uint32_t i = 0; i < graph.poses().size(); ++i)
    if (graph.isHeld({i}) || (parts.firstOf(i) == i && determined.count(i) == 0))
      gauges.push_back(NodeId{i});
  return gauges;
}

}  // namespace revisit_slam
