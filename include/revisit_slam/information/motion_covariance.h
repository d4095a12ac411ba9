// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Covariance of the motion from one scan to the next, for right perturbations in the base frame:
///
///   Sigma = s * Lambda^-1 + diag((k * E|u - u_before|)^2)
///
/// The first term is that of the registration: the information has the unit of the objective, and
/// for least squares with residuals of variance v the scale is s = 2 v, with v estimated as the
/// mean squared residual at the solution. The second term is that of deskewing: what the motion
/// that a scan was deskewed with missed, u, bent the scan by as much from its first point to its
/// last, and moves its pose by a share k of it, whatever the geometry. Under constant acceleration
/// it moves all poses alike and leaves the motions right; what counts is how u changes from scan to
/// scan. E is a running mean for each axis; that of squares would be ruled by few scans. The
/// factors were measured against ground truth (docs/information.md).
class MotionCovariance {
 public:
  explicit MotionCovariance(const InformationConfig& config) { reconfigure(config); }

  /// Takes the deskewing's error of the next scan into the running mean.
  void observe(const Tangent& deskew_error);

  Matrix6 of(const InformationEstimate& estimate) const;

  /// The information of a motion with this covariance, in the unit of the objective where its mean
  /// squared residual is `mean_squared_residual`, m^2.
  Matrix6 informationOf(const Matrix6& covariance, double mean_squared_residual) const;

  void reconfigure(const InformationConfig& config);

 private:
  double calibration_;
  double deskew_share_;
  Tangent deskew_error_ = Tangent::Zero();  // of the scan before
  Tangent mean_change_ = Tangent::Zero();
};

/// Covariance of the pose in the odometry frame, as it grows with every motion: right perturbations
/// of T_odom_base, [translation; rotation] in the base frame.
class PoseCovariance {
 public:
  explicit PoseCovariance(const Matrix6& start = Matrix6::Zero()) : covariance_(start) {}

  /// `T_previous_current`: the motion; `covariance_motion`: in the current base frame.
  void move(const Pose& T_previous_current, const Matrix6& covariance_motion);
  const Matrix6& base() const { return covariance_; }

 private:
  Matrix6 covariance_;
};

/// Right perturbations in the base frame turned into the axes of the frame that the pose is given
/// in, as ROS messages have them: (x, y, z, rotation about X, Y, Z).
Matrix6 inFixedAxes(const Matrix6& covariance_base, const Pose& T_fixed_base);

}  // namespace revisit_slam
