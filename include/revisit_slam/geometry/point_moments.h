// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace revisit_slam {

/// Principal axes of some points: variances in ascending order, axes as columns.
struct PrincipalAxes {
  Eigen::Vector3f variances;
  Eigen::Matrix3f axes;
};

/// Count, sum and sum of squares of points, all relative to one origin near them.
struct PointMoments {
  float count = 0.0f;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();

  void add(const Eigen::Vector3f& point) {
    count += 1.0f;
    sum += point;
    squares += point * point.transpose();
  }

  /// Adds points that are given relative to an origin that lies at `shift` from this one.
  void add(const PointMoments& other, const Eigen::Vector3f& shift) {
    const Eigen::Matrix3f mixed = other.sum * shift.transpose();
    squares += other.squares + mixed + mixed.transpose() + other.count * shift * shift.transpose();
    sum += other.sum + other.count * shift;
    count += other.count;
  }

  /// Of at least one point.
  PrincipalAxes principalAxes() const {
    const Eigen::Vector3f mean = sum / count;
    const Eigen::Matrix3f covariance = squares / count - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(covariance);
    return {solver.eigenvalues().cwiseMax(0.0f), solver.eigenvectors()};
  }
};

}  // namespace revisit_slam
