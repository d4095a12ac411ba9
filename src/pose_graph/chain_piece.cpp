// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_piece.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace revisit_slam {
namespace {

/// Share of the largest eigenvalue below which a direction counts as this well known, so that what
/// is known nothing about has a finite covariance.
constexpr double kWeakest = 1e-9;

Matrix6 clampedInverse(const Matrix6& information) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(information);
  const double largest = eigen.eigenvalues()[5];
  const double lowest = largest > 0.0 ? kWeakest * largest : 1.0;
  const Tangent inverse = eigen.eigenvalues().cwiseMax(lowest).cwiseInverse();
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

Matrix6 covarianceOf(const RelativePoseFactor& link) {
  const Matrix6 symmetric = 0.5 * (link.information + link.information.transpose());
  const Eigen::LLT<Matrix6> cholesky(symmetric);
  const Tangent pivots = cholesky.matrixLLT().diagonal().cwiseAbs2();
  if (cholesky.info() == Eigen::Success && pivots.minCoeff() > kWeakest * pivots.maxCoeff())
    return cholesky.solve(Matrix6::Identity());
  return clampedInverse(symmetric);
}

/// D_k and S_k of a node of the piece.
struct DeadReckoning {
  Pose T_first_node;
  Matrix6 covariance = Matrix6::Zero();

  void advance(const RelativePoseFactor& link) {
    const Matrix6 A = adjoint(link.T_from_to.inverse());
    T_first_node = T_first_node * link.T_from_to;
    covariance = A * covariance * A.transpose() + covarianceOf(link);
  }
};

}  // namespace

const RelativePoseFactor* chainLink(const Factor& factor) {
  const auto* link = std::get_if<RelativePoseFactor>(&factor.measurement);
  const bool is_link = link != nullptr && factor.kernel.type == KernelType::none &&
                       link->to().value == link->from().value + 1;
  return is_link ? link : nullptr;
}

RelativePoseFactor composed(const ChainPiece& piece) {
  if (piece.size() == 1) return *piece.front();
  DeadReckoning last;
  for (const RelativePoseFactor* link : piece) last.advance(*link);
  return {{piece.front()->from(), piece.back()->to()},
          last.T_first_node,
          last.covariance.llt().solve(Matrix6::Identity())};
}

std::vector<Pose> bentPiece(const ChainPiece& piece, const Pose& T_map_first,
                            const Pose& T_map_last) {
  std::vector<DeadReckoning> nodes(1);
  for (const RelativePoseFactor* link : piece) {
    nodes.push_back(nodes.back());
    nodes.back().advance(*link);
  }
  const Pose T_last_first = nodes.back().T_first_node.inverse();
  const Tangent deviation = log(T_last_first * (T_map_first.inverse() * T_map_last));
  const Tangent pull = nodes.back().covariance.llt().solve(deviation);
  std::vector<Pose> inner;
  for (std::size_t k = 1; k + 1 < nodes.size(); ++k) {
    const Matrix6 A = adjoint(T_last_first * nodes[k].T_first_node);
    const Tangent share = nodes[k].covariance * (A.transpose() * pull);
    inner.push_back(T_map_first * boxplus(nodes[k].T_first_node, share));
  }
  return inner;
}

}  // namespace revisit_slam
