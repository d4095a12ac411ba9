// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/factor_shape.h"

namespace revisit_slam {

/// A measurement of where a point of one node's frame lies in the frame of another: an antenna of
/// the base in east, north and up. Of the poses T_i = T_map_from and T_j = T_map_to with rotations
/// R_i, R_j the residual is
///
///   e = T_i^-1 T_j p_to - p_from, metres along the axes of i,
///
/// with, for right perturbations T * Exp([translation; rotation]),
///
///   de/dd_i = [-I, skew(T_i^-1 T_j p_to)],  de/dd_j = R_i^T R_j [I, -skew(p_to)].
struct RelativePositionFactor {
  using Shape = FactorShape<3, 2>;

  Shape::Nodes nodes;  ///< from, to
  Eigen::Vector3d p_to = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_from = Eigen::Vector3d::Zero();           ///< as measured
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< along the axes of i

  Eigen::Vector3d error(const Shape::Poses& T_map_node) const;
  Shape::Linearization linearized(const Shape::Poses& T_map_node, const Eigen::Matrix3d& U) const;
  bool isFinite() const;
};

}  // namespace revisit_slam
