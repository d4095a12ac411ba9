// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/types/constraint.h"

namespace revisit_slam {

/// Poses T_map_scan of all scans and the constraints between them. A value: a copy of it can be
/// solved while the original grows. The first node is the gauge and never moves.
class PoseGraph {
 public:
  ScanId addNode(const Pose& T_map_scan);

  /// @throws std::invalid_argument for a constraint from or to a node that is not there, or between
  /// a node and itself.
  void addOdometry(const Constraint& constraint);
  LoopId addLoop(const Constraint& constraint);

  /// Poses of the first nodes, up to as many as there are, from a solution. Later nodes stay where
  /// they were relative to the last node of the solution.
  void correct(const std::vector<Pose>& solved);

  const std::vector<Pose>& poses() const { return poses_; }
  const Pose& pose(ScanId id) const { return poses_.at(id.value); }
  const std::vector<Constraint>& odometry() const { return odometry_; }
  const std::vector<Constraint>& loops() const { return loops_; }

 private:
  void requireNodesOf(const Constraint& constraint) const;

  std::vector<Pose> poses_;  ///< by ScanId
  std::vector<Constraint> odometry_;
  std::vector<Constraint> loops_;  ///< by LoopId
};

/// Whether every number in the graph is finite, and not so large that its square is not.
bool isFinite(const PoseGraph& graph);

}  // namespace revisit_slam
