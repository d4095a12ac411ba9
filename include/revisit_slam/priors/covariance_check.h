// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>

namespace revisit_slam {

/// A covariance as drivers write it, with variances of zero and above. Some fill all entries with
/// one number, or have correlations that cannot be: nothing can be weighed with these, so of such a
/// matrix the diagonal is what is left.
template <int N>
Eigen::Matrix<double, N, N> withPossibleCorrelations(const Eigen::Matrix<double, N, N>& matrix) {
  constexpr double least = 1e-6;  // eigenvalue of the correlations
  using Square = Eigen::Matrix<double, N, N>;
  Square correlation = Square::Identity();
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      const double scale = std::sqrt(matrix(i, i) * matrix(j, j));
      if (i == j) continue;
      if (scale > 0.0)
        correlation(i, j) = matrix(i, j) / scale;
      else if (matrix(i, j) != 0.0)
        return matrix.diagonal().asDiagonal();
    }
  const Square symmetric = 0.5 * (correlation + correlation.transpose());
  const Eigen::SelfAdjointEigenSolver<Square> solver(symmetric, Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues()[0] > least)) return matrix.diagonal().asDiagonal();
  return 0.5 * (matrix + matrix.transpose());
}

}  // namespace revisit_slam
