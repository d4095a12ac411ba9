// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/odometry_drift.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace revisit_slam {
namespace {

/// Of an information that knows its best direction as well as `block` does, what the drift leaves.
double shareOf(const Eigen::Matrix3d& block, double drift) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(block, Eigen::EigenvaluesOnly);
  return 1.0 / (1.0 + std::max(0.0, eigen.eigenvalues()[2]) * drift * drift);
}

}  // namespace

/// Errors of translation and of rotation grow in the proportion of the information's own.
Matrix6 withDrift(const Matrix6& information, double metres, const BackEndConfig& config) {
  Tangent scale;
  scale.head<3>().setConstant(
      std::sqrt(shareOf(information.topLeftCorner<3, 3>(), config.drift * metres)));
  scale.tail<3>().setConstant(
      std::sqrt(shareOf(information.bottomRightCorner<3, 3>(), config.turn_drift * metres)));
  return scale.asDiagonal() * information * scale.asDiagonal();
}

}  // namespace revisit_slam
