// SPDX-License-Identifier: MIT
#include "revisit_slam/types/se3.h"

#include <cmath>

namespace revisit_slam {
namespace {

/// Below this angle the closed forms lose digits and their series are exact to double precision.
constexpr double kSmallAngle = 1e-4;

/// Coupling block of the left Jacobian of SE(3): Barfoot, State Estimation for Robotics, Eq. 7.86.
Eigen::Matrix3d leftJacobianCoupling(const Eigen::Vector3d& translation,
                                     const Eigen::Vector3d& rotation) {
  const double angle2 = rotation.squaredNorm();
  const double angle = std::sqrt(angle2);
  double a = 1.0 / 6.0, b = 1.0 / 24.0, c = 1.0 / 120.0;
  if (angle > 1e-2) {
    a = (angle - std::sin(angle)) / (angle2 * angle);
    b = (angle2 + 2.0 * std::cos(angle) - 2.0) / (2.0 * angle2 * angle2);
    c = (2.0 * angle - 3.0 * std::sin(angle) + angle * std::cos(angle)) /
        (2.0 * angle2 * angle2 * angle);
  } else {
    a -= angle2 / 120.0;
    b -= angle2 / 720.0;
    c -= angle2 / 2520.0;
  }
  const Eigen::Matrix3d P = skew(translation), W = skew(rotation);
  const Eigen::Matrix3d WP = W * P, PW = P * W, WPW = WP * W;
  return 0.5 * P + a * (WP + PW + WPW) + b * (W * WP + PW * W - 3.0 * WPW) +
         c * (WPW * W + W * WPW);
}

}  // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d S;
  S << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return S;
}

Eigen::Quaterniond expSO3(const Eigen::Vector3d& rotation) {
  const double half = 0.5 * rotation.norm();
  const double sinc = half < kSmallAngle ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  Eigen::Quaterniond q;
  q.w() = std::cos(half);
  q.vec() = 0.5 * sinc * rotation;
  return q;
}

Eigen::Vector3d logSO3(const Eigen::Quaterniond& rotation) {
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;  // q and -q are one rotation
  const Eigen::Vector3d v = sign * rotation.vec();
  const double sine = v.norm();
  if (sine < kSmallAngle) return (2.0 + sine * sine / 3.0) * v;
  return (2.0 * std::atan2(sine, sign * rotation.w()) / sine) * v;
}

Eigen::Matrix3d leftJacobianSO3(const Eigen::Vector3d& rotation) {
  const double angle2 = rotation.squaredNorm();
  const double angle = std::sqrt(angle2);
  const bool small = angle < kSmallAngle;
  const double a = small ? 0.5 - angle2 / 24.0 : (1.0 - std::cos(angle)) / angle2;
  const double b =
      small ? 1.0 / 6.0 - angle2 / 120.0 : (angle - std::sin(angle)) / (angle2 * angle);
  const Eigen::Matrix3d W = skew(rotation);
  return Eigen::Matrix3d::Identity() + a * W + b * W * W;
}

Eigen::Matrix3d leftJacobianInverseSO3(const Eigen::Vector3d& rotation) {
  const double angle2 = rotation.squaredNorm();
  const double angle = std::sqrt(angle2);
  const double b = angle < 1e-2 ? 1.0 / 12.0 + angle2 / 720.0
                                : 1.0 / angle2 - 0.5 / (angle * std::tan(0.5 * angle));
  const Eigen::Matrix3d W = skew(rotation);
  return Eigen::Matrix3d::Identity() - 0.5 * W + b * W * W;
}

Pose exp(const Tangent& tangent) {
  const Eigen::Vector3d rotation = tangent.tail<3>();
  return {expSO3(rotation), leftJacobianSO3(rotation) * tangent.head<3>()};
}

Tangent log(const Pose& T) {
  const Eigen::Vector3d rotation = logSO3(T.rotation);
  Tangent tangent;
  tangent << leftJacobianInverseSO3(rotation) * T.translation, rotation;
  return tangent;
}

Matrix6 adjoint(const Pose& T) {
  const Eigen::Matrix3d R = T.rotationMatrix();
  Matrix6 A;
  A << R, skew(T.translation) * R, Eigen::Matrix3d::Zero(), R;
  return A;
}

Matrix6 rightJacobianInverse(const Tangent& tangent) {
  const Eigen::Vector3d translation = -tangent.head<3>(), rotation = -tangent.tail<3>();
  const Eigen::Matrix3d J_inverse = leftJacobianInverseSO3(rotation);
  const Eigen::Matrix3d Q = leftJacobianCoupling(translation, rotation);
  Matrix6 J;
  J << J_inverse, -J_inverse * Q * J_inverse, Eigen::Matrix3d::Zero(), J_inverse;
  return J;
}

}  // namespace revisit_slam
