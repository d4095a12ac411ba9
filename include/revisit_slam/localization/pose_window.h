// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "revisit_slam/pose_graph/back_end_config.h"
#include "revisit_slam/pose_graph/graph_node.h"

namespace revisit_slam {

/// A graph of the last scans: their odometry edges, and where registrations have put some of them
/// in the map. Older ones are left out.
class PoseWindow {
 public:
  explicit PoseWindow(const BackEndConfig& config) : config_(config) {}

  /// The next scan of the session.
  void add(const GraphNode& node) { nodes_.push_back({node, {}, Matrix6::Zero()}); }
  /// Where the newest scan is, with the information of that for right perturbations.
  void fix(const Pose& T_map_base, const Matrix6& information);
  /// Forgets fixes; what was added stays.
  void clearFixes();
  /// Leaves out scans farther than `metres` from the newest along the way.
  void shorten(double metres);

  /// T_map_odom at the newest scan: the minimum of all edges and fixes. None without a fix, or
  /// where the solver fails.
  std::optional<Pose> solve() const;

 private:
  struct Node {
    GraphNode node;
    std::optional<Pose> T_map_base;
    Matrix6 information = Matrix6::Zero();  // of it
  };

  BackEndConfig config_;
  std::deque<Node> nodes_;
};

}  // namespace revisit_slam
