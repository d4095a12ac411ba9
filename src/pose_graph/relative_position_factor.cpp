// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/relative_position_factor.h"

#include <cmath>

namespace revisit_slam {

Eigen::Vector3d RelativePositionFactor::error(const Shape::Poses& T_map_node) const {
  return T_map_node[0].inverse() * (T_map_node[1] * p_to) - p_from;
}

RelativePositionFactor::Shape::Linearization RelativePositionFactor::linearized(
    const Shape::Poses& T_map_node, const Eigen::Matrix3d& U) const {
  const Pose T_from_to = T_map_node[0].inverse() * T_map_node[1];
  const Eigen::Vector3d seen = T_from_to * p_to;
  const Eigen::Matrix3d by_to = U * T_from_to.rotationMatrix();
  Shape::Jacobian J_from, J_to;
  J_from << -U, U * skew(seen);
  J_to << by_to, -by_to * skew(p_to);
  return {U * (seen - p_from), {J_from, J_to}};
}

bool RelativePositionFactor::isFinite() const {
  return std::isfinite(p_to.squaredNorm()) && std::isfinite(p_from.squaredNorm()) &&
         std::isfinite(information.squaredNorm());
}

}  // namespace revisit_slam
