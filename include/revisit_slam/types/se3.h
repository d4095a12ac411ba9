// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Tangent vector of SE(3): [translation; rotation], metres and radians.
using Tangent = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The matrix with skew(a) * b = a x b.
Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// Exponential and logarithm of SO(3), rotation vectors in radians, |log| <= pi.
Eigen::Quaterniond expSO3(const Eigen::Vector3d& rotation);
Eigen::Vector3d logSO3(const Eigen::Quaterniond& rotation);

/// Left Jacobian of SO(3) and its inverse: Exp(w + d) = Exp(J d) Exp(w) to first order.
Eigen::Matrix3d leftJacobianSO3(const Eigen::Vector3d& rotation);
Eigen::Matrix3d leftJacobianInverseSO3(const Eigen::Vector3d& rotation);

Pose exp(const Tangent& tangent);
Tangent log(const Pose& T);

/// T * Exp(d) = Exp(adjoint(T) * d) * T.
Matrix6 adjoint(const Pose& T);

/// Log(Exp(x) * Exp(d)) = x + rightJacobianInverse(x) * d to first order.
Matrix6 rightJacobianInverse(const Tangent& tangent);

/// Right (body-frame) perturbation: T * Exp(d).
inline Pose boxplus(const Pose& T, const Tangent& d) {
  return T * exp(d);
}

}  // namespace revisit_slam
