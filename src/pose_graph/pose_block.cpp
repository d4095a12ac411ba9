// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/pose_block.h"

namespace revisit_slam {
namespace {

template <int rows, int cols>
using RowMajor = Eigen::Matrix<double, rows, cols, Eigen::RowMajor>;

/// The 4x3 matrix D(q) with q * (w/2, 0) = D(q) w, coefficients x y z w; D^T D = I/4.
RowMajor<4, 3> quaternionPlusJacobian(const Eigen::Quaterniond& q) {
  RowMajor<4, 3> D;
  D << q.w(), -q.z(), q.y(),  //
      q.z(), q.w(), -q.x(),   //
      -q.y(), q.x(), q.w(),   //
      -q.x(), -q.y(), -q.z();
  return 0.5 * D;
}

}  // namespace

PoseBlock blockOf(const Pose& T) {
  const Eigen::Quaterniond& q = T.rotation;
  const Eigen::Vector3d& t = T.translation;
  return {q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z()};
}

Pose poseOf(const double* block) {
  return {Eigen::Quaterniond(block[3], block[0], block[1], block[2]),
          Eigen::Vector3d(block[4], block[5], block[6])};
}

bool PoseChart::plus(const double* block, const double* d, double* moved) {
  const PoseBlock result = blockOf(boxplus(poseOf(block), Eigen::Map<const Tangent>(d)));
  std::copy(result.begin(), result.end(), moved);
  return true;
}

bool PoseChart::minus(const double* moved, const double* block, double* d) {
  Eigen::Map<Tangent>{d} = log(poseOf(block).inverse() * poseOf(moved));
  return true;
}

bool PoseChart::plusJacobian(const double* block, double* J) {
  const Pose T = poseOf(block);
  Eigen::Map<RowMajor<7, 6>> jacobian(J);
  jacobian.setZero();
  jacobian.topRightCorner<4, 3>() = quaternionPlusJacobian(T.rotation);
  jacobian.bottomLeftCorner<3, 3>() = T.rotationMatrix();
  return true;
}

bool PoseChart::minusJacobian(const double* block, double* J) {
  const Pose T = poseOf(block);
  Eigen::Map<RowMajor<6, 7>> jacobian(J);
  jacobian.setZero();
  jacobian.topRightCorner<3, 3>() = T.rotationMatrix().transpose();
  jacobian.bottomLeftCorner<3, 4>() = 4.0 * quaternionPlusJacobian(T.rotation).transpose();
  return true;
}

}  // namespace revisit_slam
