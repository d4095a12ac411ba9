// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Kalman filter of the velocity of a base that is registered scan by scan
/// (docs/odometry_appendix.md). Its state is the error of the velocity and, correlated with it,
/// that of the pose in the map which scans are registered to. Between scans the velocity changes by
/// c ~ N(0, A seconds^2) with independent axes. A, how jerky the platform is, follows from the
/// changes that are observed, by recursive expectation maximisation: an axis that nothing is
/// observed of keeps its A.
class VelocityFilter {
 public:
  /// Of the deviation of a pose from its prediction, [m; rad] in the base frame. `T_previous_base`:
  /// the predicted motion.
  Matrix6 predictedCovariance(const Pose& T_previous_base, double seconds) const;

  /// Takes in that the pose, of registration and prediction together, deviates by `deviation` from
  /// the prediction. `information`: of the registration alone; singular, even zero, is welcome.
  /// @return what has to be added to the velocity, [m/s; rad/s].
  Tangent update(const Pose& T_previous_base, double seconds, const Tangent& deviation,
                 const Matrix6& information);

  /// The velocity was seen for the first time, as a difference of two poses.
  void start(double seconds, const Matrix6& information);

  /// Standard deviations of the accelerations, [m/s^2; rad/s^2].
  Tangent acceleration() const { return acceleration_variance_.cwiseSqrt(); }

 private:
  struct Prediction {
    Matrix6 pose, pose_velocity, velocity, change;
  };
  Prediction predict(const Pose& T_previous_base, double seconds) const;
  void learn(const Tangent& change, const Matrix6& covariance, double seconds);

  Matrix6 pose_ = Matrix6::Zero();
  Matrix6 pose_velocity_ = Matrix6::Zero();
  Matrix6 velocity_ = Matrix6::Zero();
  Tangent acceleration_variance_ = Tangent::Constant(kInitialAcceleration * kInitialAcceleration);
  int learned_ = 0;

  /// m/s^2, rad/s^2, before any was seen.
  static constexpr double kInitialAcceleration = 3.0;
};

}  // namespace revisit_slam
