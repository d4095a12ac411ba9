// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/information_root.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace revisit_slam {

Matrix6 informationRoot(const Matrix6& information) {
  const Matrix6 symmetric = 0.5 * (information + information.transpose());
  const Eigen::LLT<Matrix6> cholesky(symmetric);
  if (cholesky.info() == Eigen::Success) return cholesky.matrixU();
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(symmetric);
  const Tangent roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return roots.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace revisit_slam
