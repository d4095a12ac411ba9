// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "revisit_slam/odometry/motion.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/odometry/sweep_motion.h"
#include "revisit_slam/odometry/velocity_filter.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// What is expected of the base between the previous scan and an instant.
struct PredictedMotion {
  Pose T_previous_base;  ///< the base at the instant, in its frame at the previous scan
  /// Of the deviation d = Log(T_previous_base^-1 * T_previous_true), [m; rad] in the base frame at
  /// the instant. None: nothing is known of the motion, and the registration alone decides.
  std::optional<Matrix6> covariance;
  /// What the scan is deskewed with. Without a gap T_previous_base is velocity.after(seconds): the
  /// deskew correction takes times as fractions of that.
  ConstantMotion velocity;
  /// Instead, where the motion within the sweep was measured as well.
  std::optional<SweepMotion> sweep;
  /// From the previous scan, in whole, however far the motion is extrapolated; 0: there is none.
  double seconds = 0.0;
  /// Whether motion was seen before, and lately: what the prediction misses then says something
  /// about the motion. False at the first two scans and after a long gap.
  bool is_known = false;
  /// Too long since the last scan that told of the motion to extrapolate all of it.
  bool is_after_gap = false;
  /// From the last scan that told of the motion, and for how much of it the scans since have been
  /// moved on; without such scans `seconds` and 0.
  double seconds_untold = 0.0, extrapolated = 0.0;
  /// By wheels, for one: what it misses is not an error of extrapolation.
  bool is_measured = false;
  /// By which it is then weighed beside the registration: more than the inverse of `covariance`, as
  /// errors of the registration last from scan to scan, and those of sensors do not.
  Matrix6 information = Matrix6::Zero();
};

/// Predicts the motion of the base from scan to scan. Constant velocity is one way; wheels or a
/// gyro are others.
class MotionPredictor {
 public:
  virtual ~MotionPredictor() = default;

  virtual PredictedMotion predict(Stamp stamp) const = 0;

  /// The base is held to be at this pose, that of registration and prediction together.
  /// `information`: what the registration alone tells of it, the inverse of a covariance of right
  /// perturbations [m; rad] in the base frame; zero where too little matched and the pose is the
  /// prediction. Directions without information are no observation. Stamps ascend.
  virtual void observe(Stamp stamp, const Pose& T_odom_base, const Matrix6& information) = 0;

  /// The track is lost: the motion so far says nothing of what follows.
  virtual void forget() = 0;

  /// Takes over what may change between two scans.
  virtual void reconfigure(const OdometryConfig&) {}
};

/// The base goes on as it did between the two scans before (KISS-ICP Sec. III-A). Over longer gaps
/// than max_prediction_time it is extrapolated only so far, and likewise where scans tell nothing
/// of the motion for so long: with a covered sensor the base does not fly on for ever. How far the
/// motion may deviate follows from the accelerations that this platform has shown (VelocityFilter).
class ConstantVelocityPredictor final : public MotionPredictor {
 public:
  explicit ConstantVelocityPredictor(const OdometryConfig& config) { reconfigure(config); }

  PredictedMotion predict(Stamp stamp) const override;
  void observe(Stamp stamp, const Pose& T_odom_base, const Matrix6& information) override;
  void forget() override;
  void reconfigure(const OdometryConfig& config) override {
    max_prediction_time_ = config.max_prediction_time;
  }

 private:
  Matrix6 covarianceOf(const PredictedMotion& predicted) const;
  double untold() const;
  double longestExtrapolation() const;

  double max_prediction_time_ = 0.0;  // s
  int observed_ = 0;                  // up to 2
  Stamp previous_stamp_, told_stamp_;
  Pose T_odom_previous_, T_odom_told_;  // at the last scan, and at the last that told of the motion
  ConstantMotion motion_;
  VelocityFilter filter_;
};

}  // namespace revisit_slam
