// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gravity_factor.h"

#include <cmath>

namespace revisit_slam {
namespace {

struct Rotations {
  Eigen::Matrix3d R_imu_base, R_base_level;
};

Rotations rotationsOf(const GravityFactor::Shape::Poses& T_map_node) {
  const auto& [first, imu, level, scan] = T_map_node;
  return {(imu.rotation.conjugate() * first.rotation).toRotationMatrix(),
          (scan.rotation.conjugate() * level.rotation).toRotationMatrix()};
}

}  // namespace

Eigen::Vector3d GravityFactor::error(const Shape::Poses& T_map_node) const {
  const Rotations R = rotationsOf(T_map_node);
  return up - R.R_imu_base * R.R_base_level.col(2);
}

GravityFactor::Shape::Linearization GravityFactor::linearized(const Shape::Poses& T_map_node,
                                                              const Eigen::Matrix3d& U) const {
  const Rotations R = rotationsOf(T_map_node);
  const Eigen::Vector3d w = R.R_base_level.col(2), v = R.R_imu_base * w;
  const Eigen::Matrix3d by_base = U * R.R_imu_base * skew(w);
  const auto byRotation = [](const Eigen::Matrix3d& derivative) {
    Shape::Jacobian J = Shape::Jacobian::Zero();
    J.rightCols<3>() = derivative;
    return J;
  };
  return {U * (up - v),
          {byRotation(by_base), byRotation(-U * skew(v)),
           byRotation(U * R.R_imu_base * R.R_base_level * skew(Eigen::Vector3d::UnitZ())),
           byRotation(-by_base)}};
}

bool GravityFactor::isFinite() const {
  return std::isfinite(up.squaredNorm()) && std::isfinite(information.squaredNorm());
}

}  // namespace revisit_slam
