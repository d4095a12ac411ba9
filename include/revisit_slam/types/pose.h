// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace revisit_slam {

/// A rigid transform. A variable `T_a_b` of this type maps points of frame b into frame a:
/// p_a = T_a_b * p_b. The rotation stays a unit quaternion under composition.
struct Pose {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  static Pose identity() { return {}; }
  static Pose fromMatrix(const Eigen::Matrix4d& T) {
    return {Eigen::Quaterniond(T.topLeftCorner<3, 3>()).normalized(), T.topRightCorner<3, 1>()};
  }

  Pose inverse() const {
    const Eigen::Quaterniond inverse_rotation = rotation.conjugate();
    return {inverse_rotation, -(inverse_rotation * translation)};
  }

  Eigen::Matrix3d rotationMatrix() const { return rotation.toRotationMatrix(); }

  Eigen::Matrix4d matrix() const {
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    T.topLeftCorner<3, 3>() = rotationMatrix();
    T.topRightCorner<3, 1>() = translation;
    return T;
  }

  /// Angle of the rotation in [0, pi], radians.
  double angle() const { return 2.0 * std::atan2(rotation.vec().norm(), std::abs(rotation.w())); }

  friend Pose operator*(const Pose& T_a_b, const Pose& T_b_c) {
    return {(T_a_b.rotation * T_b_c.rotation).normalized(),
            T_a_b.translation + T_a_b.rotation * T_b_c.translation};
  }
  friend Eigen::Vector3d operator*(const Pose& T_a_b, const Eigen::Vector3d& p_b) {
    return T_a_b.rotation * p_b + T_a_b.translation;
  }
};

}  // namespace revisit_slam
