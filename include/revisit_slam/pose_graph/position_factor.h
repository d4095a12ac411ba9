// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/factor_shape.h"

namespace revisit_slam {

/// A measurement of where a point of a node's frame, say its antenna, lies in the map. Of the pose
/// T = T_map_node with rotation R the residual and its derivative by the right perturbation
/// T * Exp([translation; rotation]) are
///
///   e = T p_node - p_map, metres along the axes of the map,  de/dd = [R, -R skew(p_node)].
struct PositionFactor {
  using Shape = FactorShape<3, 1>;

  Shape::Nodes nodes;
  Eigen::Vector3d p_node = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_map = Eigen::Vector3d::Zero();            ///< as measured
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< along the axes of the map

  Eigen::Vector3d error(const Shape::Poses& T_map_node) const;
  Shape::Linearization linearized(const Shape::Poses& T_map_node, const Eigen::Matrix3d& U) const;
  bool isFinite() const;
};

}  // namespace revisit_slam
