// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace revisit_slam {

/// A matrix U with U^T U = information, so that |U e|^2 = e^T information e. Where the information
/// is only semi-definite, its negative eigenvalues (round-off) count as zero. Of an asymmetric
/// matrix the symmetric part counts, which is all that a quadratic form sees.
template <int rows>
Eigen::Matrix<double, rows, rows> informationRoot(
    const Eigen::Matrix<double, rows, rows>& information) {
  using Matrix = Eigen::Matrix<double, rows, rows>;
  const Matrix symmetric = 0.5 * (information + information.transpose());
  const Eigen::LLT<Matrix> cholesky(symmetric);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixU();
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(symmetric);
  const Eigen::Matrix<double, rows, 1> roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return roots.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace revisit_slam
