// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "revisit_slam/pose_graph/gravity_factor.h"
#include "revisit_slam/pose_graph/position_factor.h"
#include "revisit_slam/pose_graph/relative_pose_factor.h"
#include "revisit_slam/pose_graph/relative_position_factor.h"
#include "revisit_slam/pose_graph/robust_kernel.h"

namespace revisit_slam {

/// What a factor measures. To add a kind of factor,
///
///   1. declare a struct in a header of its own, as position_factor.h does: its Shape, the nodes it
///      binds, its information, error(), linearized() and isFinite();
///   2. define these in a source of its own;
///   3. name the struct here.
///
/// Cost, solver, chain reduction and gauge then handle it. One that binds a single node counts as
/// absolute: it can hold a part of the graph in the map (gauge.h). Unless the absolute factors of a
/// part determine all six directions together, its first node is held whole; the map's z axis is
/// that of the first scan's base then, and need not point up. One that binds several must not
/// change when these are moved together. A node that such a factor binds is kept by the chain
/// reduction.
using Measurement =
    std::variant<RelativePoseFactor, PositionFactor, RelativePositionFactor, GravityFactor>;

/// The nodes that a factor binds, as a range.
class FactorNodes {
 public:
  FactorNodes(const NodeId* begin, std::size_t size) : begin_(begin), size_(size) {}
  const NodeId* begin() const { return begin_; }
  const NodeId* end() const { return begin_ + size_; }
  std::size_t size() const { return size_; }

 private:
  const NodeId* begin_;
  std::size_t size_;
};

/// A term 1/2 rho(chi2) of the cost of a graph, with chi2 = e^T information e.
struct Factor {
  Measurement measurement;
  RobustKernel kernel;  ///< rho

  FactorNodes nodes() const;
  /// With the poses T_map_node of all nodes, by NodeId.
  double chi2(const std::vector<Pose>& poses) const;
  /// Whether every number is finite, and not so large that its square is not.
  bool isFinite() const;
  /// The same factor in a graph where its nodes have other ids.
  Factor renumbered(const std::vector<NodeId>& new_ids) const;
};

/// The poses of the nodes that a measurement binds.
template <typename Measured>
typename Measured::Shape::Poses posesOf(const Measured& measured, const std::vector<Pose>& poses) {
  typename Measured::Shape::Poses result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = poses[measured.nodes[k].value];
  return result;
}

}  // namespace revisit_slam
