// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/ring_limit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace revisit_slam {
namespace {

/// Rings weigh at most this share of all else.
constexpr double kLargestShare = 0.05;
/// Where there is nothing else they keep the equations from being singular.
constexpr double kLeastFactor = 1e-3;

}  // namespace

void RingLimit::update(const NormalEquations& equations) {
  if (motion_is_seen_) return;
  const double limited = equations.ringWeight(), unlimited = limited / factor_;
  factor_ = 1.0;
  seen_.setIdentity();
  if (unlimited <= 0.0) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      Eigen::Matrix3d(equations.H().topLeftCorner<3, 3>()));
  Eigen::Matrix3d seen = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const double all_else = solver.eigenvalues()[i] - limited;
    const Eigen::Vector3d direction = solver.eigenvectors().col(i);
    if (kLargestShare * all_else < unlimited) seen -= direction * direction.transpose();
  }
  seen_.topLeftCorner<3, 3>() = seen;
  const double least = solver.eigenvalues()[0] - limited;
  factor_ = std::clamp(kLargestShare * least / unlimited, kLeastFactor, 1.0);
}

Matrix6 RingLimit::limited(const Matrix6& weight) const {
  return seen_ * weight * seen_;
}

}  // namespace revisit_slam
