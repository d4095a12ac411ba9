// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/relative_pose_cost.h"

#include "revisit_slam/pose_graph/information_root.h"

namespace revisit_slam {
namespace {

/// The derivative by a right perturbation of a pose block -> by the block's entries.
void writeBlockJacobian(const Matrix6& by_perturbation, const double* block, double* jacobian) {
  using Jacobian = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;
  Jacobian minus;
  PoseChart::minusJacobian(block, minus.data());
  Eigen::Map<Jacobian> J(jacobian);
  J.leftCols<4>().noalias() = by_perturbation.rightCols<3>() * minus.bottomLeftCorner<3, 4>();
  J.rightCols<3>().noalias() = by_perturbation.leftCols<3>() * minus.topRightCorner<3, 3>();
}

}  // namespace

Tangent relativePoseError(const Pose& T_from_to, const Pose& T_map_from, const Pose& T_map_to) {
  return log(T_from_to.inverse() * (T_map_from.inverse() * T_map_to));
}

double chi2(const Constraint& constraint, const Pose& T_map_from, const Pose& T_map_to) {
  const Tangent e = relativePoseError(constraint.T_from_to, T_map_from, T_map_to);
  return e.dot(constraint.information * e);
}

RelativePoseCost::RelativePoseCost(const Constraint& constraint)
    : T_to_from_(constraint.T_from_to.inverse()), root_(informationRoot(constraint.information)) {}

bool RelativePoseCost::Evaluate(double const* const* blocks, double* residuals,
                                double** jacobians) const {
  const Pose T_i_j = poseOf(blocks[0]).inverse() * poseOf(blocks[1]);
  const Tangent e = log(T_to_from_ * T_i_j);
  Eigen::Map<Tangent>{residuals}.noalias() = root_ * e;
  if (jacobians == nullptr) return true;
  const Matrix6 J_j = root_ * rightJacobianInverse(e);
  if (jacobians[0] != nullptr)
    writeBlockJacobian(-J_j * adjoint(T_i_j.inverse()), blocks[0], jacobians[0]);
  if (jacobians[1] != nullptr) writeBlockJacobian(J_j, blocks[1], jacobians[1]);
  return true;
}

}  // namespace revisit_slam
