// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/relative_pose_factor.h"

#include <cmath>

namespace revisit_slam {

Tangent RelativePoseFactor::error(const Shape::Poses& T_map_node) const {
  return log(T_from_to.inverse() * (T_map_node[0].inverse() * T_map_node[1]));
}

RelativePoseFactor::Shape::Linearization RelativePoseFactor::linearized(
    const Shape::Poses& T_map_node, const Matrix6& U) const {
  const Pose T_i_j = T_map_node[0].inverse() * T_map_node[1];
  const Tangent e = log(T_from_to.inverse() * T_i_j);
  const Matrix6 by_j = U * rightJacobianInverse(e);
  return {U * e, {-by_j * adjoint(T_i_j.inverse()), by_j}};
}

bool RelativePoseFactor::isFinite() const {
  return std::isfinite(T_from_to.translation.squaredNorm()) &&
         T_from_to.rotation.coeffs().allFinite() && std::isfinite(information.squaredNorm());
}

}  // namespace revisit_slam
