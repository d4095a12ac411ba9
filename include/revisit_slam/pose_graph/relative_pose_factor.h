// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/factor_shape.h"

namespace revisit_slam {

/// A measurement Z = T_from_to of where one node is, seen from another: an odometry edge or a loop.
/// Of the poses T_i = T_map_from and T_j = T_map_to the residual is
///
///   e = Log(Z^-1 T_i^-1 T_j),  [translation; rotation], metres and radians, in the frame of j,
///
/// with, for right perturbations T * Exp(d),
///
///   de/dd_j = Jr^-1(e),  de/dd_i = -Jr^-1(e) Ad(T_j^-1 T_i).
struct RelativePoseFactor {
  using Shape = FactorShape<6, 2>;

  Shape::Nodes nodes;  ///< from, to
  Pose T_from_to;
  Matrix6 information = Matrix6::Identity();  ///< in the tangent space of T_map_to

  NodeId from() const { return nodes[0]; }
  NodeId to() const { return nodes[1]; }

  Tangent error(const Shape::Poses& T_map_node) const;
  Shape::Linearization linearized(const Shape::Poses& T_map_node, const Matrix6& U) const;
  bool isFinite() const;
};

}  // namespace revisit_slam
