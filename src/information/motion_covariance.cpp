// SPDX-License-Identifier: MIT
#include "revisit_slam/information/motion_covariance.h"

#include <Eigen/LU>

namespace revisit_slam {

namespace {

/// Weight of the newest scan in the running mean: the memory is about a second at 10 Hz.
constexpr double kNewest = 0.1;

}  // namespace

void MotionCovariance::observe(const Tangent& deskew_error) {
  const Tangent change = deskew_error - deskew_error_;
  mean_change_ += kNewest * (change.cwiseAbs() - mean_change_);
  deskew_error_ = deskew_error;
}

Matrix6 MotionCovariance::of(const InformationEstimate& estimate) const {
  const double scale = 2.0 * estimate.mean_squared_residual * calibration_;
  Matrix6 covariance = scale * estimate.information.inverse();
  covariance.diagonal() += (deskew_share_ * mean_change_).cwiseAbs2();
  return covariance;
}

Matrix6 MotionCovariance::informationOf(const Matrix6& covariance,
                                        double mean_squared_residual) const {
  return 2.0 * mean_squared_residual * calibration_ * covariance.inverse();
}

void MotionCovariance::reconfigure(const InformationConfig& config) {
  calibration_ = config.calibration;
  deskew_share_ = config.deskew_share;
}

void PoseCovariance::move(const Pose& T_previous_current, const Matrix6& covariance_motion) {
  const Matrix6 A = adjoint(T_previous_current.inverse());
  covariance_ = A * covariance_ * A.transpose() + covariance_motion;
}

Matrix6 inFixedAxes(const Matrix6& covariance_base, const Pose& T_fixed_base) {
  const Eigen::Matrix3d R = T_fixed_base.rotationMatrix();
  Matrix6 J = Matrix6::Zero();
  J.topLeftCorner<3, 3>() = J.bottomRightCorner<3, 3>() = R;
  return J * covariance_base * J.transpose();
}

}  // namespace revisit_slam
