// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/position_factor.h"

#include <cmath>

namespace revisit_slam {

Eigen::Vector3d PositionFactor::error(const Shape::Poses& T_map_node) const {
  return T_map_node[0] * p_node - p_map;
}

PositionFactor::Shape::Linearization PositionFactor::linearized(const Shape::Poses& T_map_node,
                                                                const Eigen::Matrix3d& U) const {
  const Eigen::Matrix3d by_translation = U * T_map_node[0].rotationMatrix();
  Shape::Jacobian J;
  J << by_translation, -by_translation * skew(p_node);
  return {U * error(T_map_node), {J}};
}

bool PositionFactor::isFinite() const {
  return std::isfinite(p_node.squaredNorm()) && std::isfinite(p_map.squaredNorm()) &&
         std::isfinite(information.squaredNorm());
}

}  // namespace revisit_slam
