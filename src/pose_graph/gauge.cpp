// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gauge.h"

#include <algorithm>
#include <numeric>

namespace revisit_slam {
namespace {

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

  void connect(const std::vector<Constraint>& constraints) {
    for (const Constraint& constraint : constraints) {
      const std::uint32_t a = firstOf(constraint.from.value), b = firstOf(constraint.to.value);
      parent_[std::max(a, b)] = std::min(a, b);
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<ScanId> gaugeNodes(const PoseGraph& graph) {
  ConnectedParts parts(graph.poses().size());
  parts.connect(graph.odometry());
  parts.connect(graph.loops());
  std::vector<ScanId> first;
  for (std::uint32_t i = 0; i < graph.poses().size(); ++i)
    if (parts.firstOf(i) == i) first.push_back(ScanId{i});
  return first;
}

}  // namespace revisit_slam
