// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/factor.h"

namespace revisit_slam {

/// Poses T_map_node and the factors that bind them. A value: a copy of it can be solved while the
/// original grows.
class PoseGraph {
 public:
  NodeId addNode(const Pose& T_map_node);

  /// The node stays where it is. @throws std::invalid_argument for one that is not there.
  void hold(NodeId node);
  bool isHeld(NodeId node) const { return held_[node.value]; }
  /// Whether all nodes that a factor binds are held: nothing depends on it.
  bool isSettled(const Factor& factor) const;

  /// @throws std::invalid_argument for a measurement of a node that is not there, or between a node
  /// and itself.
  FactorId addFactor(const Measurement& measurement, const RobustKernel& kernel = {});

  /// Poses of the first nodes, up to as many as there are, from a solution. Later nodes stay where
  /// they were relative to the last node of the solution.
  void correct(const std::vector<Pose>& solved);

  const std::vector<Pose>& poses() const { return poses_; }
  const std::vector<Factor>& factors() const { return factors_; }

 private:
  std::vector<Pose> poses_;      ///< by NodeId
  std::vector<bool> held_;       ///< likewise
  std::vector<Factor> factors_;  ///< by FactorId
};

/// Whether every number in the graph is finite, and not so large that its square is not.
bool isFinite(const PoseGraph& graph);

}  // namespace revisit_slam
