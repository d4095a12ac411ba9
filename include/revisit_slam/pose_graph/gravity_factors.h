// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"
#include "revisit_slam/priors/gravity_config.h"
#include "revisit_slam/types/gravity_direction.h"

namespace revisit_slam {

/// The directions of gravity of a drive, or of several sessions, as factors of its graph. The first
/// scan stays the gauge and the map does not turn: which way is up in it is a node, the frame
/// `level`, and the error of each session's accelerometer is another (GravityFactor).
class GravityFactors {
 public:
  explicit GravityFactors(const GravityConfig& config) : config_(config) {}

  /// Whether the pose of a node is in the map of the first one.
  using IsInMap = std::function<bool(NodeId)>;

  /// A direction that takes part in graphs of more than `node` nodes, if gravity/enabled. `first`:
  /// the node of the first scan of its session, which gets none itself.
  void add(std::size_t node, const GravityDirection& direction, std::size_t first = 0);

  /// Whether a graph of so many nodes has directions that the last solution has not.
  bool hasNew(std::size_t nodes) const { return countOf(nodes) > used_; }
  bool any() const { return !directions_.empty(); }

  /// Adds nodes and factors to a graph that has the nodes of all scans. Those at scans in other
  /// maps do not count. `level`: the node of a frame whose z axis is up, if the graph has one.
  void addTo(PoseGraph& graph, std::optional<NodeId> level, const IsInMap& is_in_map) const;

  /// A graph of so many nodes was solved with them.
  void take(std::size_t nodes) { used_ = countOf(nodes); }

 private:
  struct Tied {
    std::size_t node;    // with which it came
    NodeId first, scan;  // of its session; that it is tied to
    Eigen::Vector3d up;
  };

  std::size_t countOf(std::size_t nodes) const;
  NodeId addLevel(PoseGraph& graph, NodeId first) const;

  GravityConfig config_;
  std::vector<Tied> directions_;  // in the order of the nodes with which they came
  std::size_t used_ = 0;          // by the last solution
};

}  // namespace revisit_slam
