// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/motion_predictor.h"

#include <algorithm>

namespace revisit_slam {
namespace {

/// 1/m^2, of a position: with less, as of a gyro alone, a scan does not tell of the motion.
constexpr double kLeastInformation = 1.0;

}  // namespace

PredictedMotion ConstantVelocityPredictor::predict(Stamp stamp) const {
  PredictedMotion predicted;
  predicted.seconds = observed_ == 0 ? 0.0 : secondsBetween(previous_stamp_, stamp);
  predicted.seconds_untold = untold() + predicted.seconds;
  predicted.extrapolated = std::min(untold(), max_prediction_time_);
  predicted.is_after_gap = predicted.seconds > longestExtrapolation();
  predicted.is_known = observed_ > 1 && !predicted.is_after_gap;
  predicted.velocity = motion_;
  predicted.T_previous_base = motion_.after(std::min(predicted.seconds, longestExtrapolation()));
  if (observed_ > 1) predicted.covariance = covarianceOf(predicted);
  return predicted;
}

/// s, from the last scan that told of the motion to the last one.
double ConstantVelocityPredictor::untold() const {
  return observed_ == 0 ? 0.0 : secondsBetween(told_stamp_, previous_stamp_);
}

double ConstantVelocityPredictor::longestExtrapolation() const {
  return std::max(0.0, max_prediction_time_ - untold());
}

/// After a gap the way that was not extrapolated may be missing as well.
Matrix6 ConstantVelocityPredictor::covarianceOf(const PredictedMotion& predicted) const {
  const double left_out = std::max(0.0, predicted.seconds - longestExtrapolation());
  const Tangent missing = left_out * predicted.velocity.velocity();
  return filter_.predictedCovariance(predicted.T_previous_base, predicted.seconds) +
         missing * missing.transpose();
}

void ConstantVelocityPredictor::observe(Stamp stamp, const Pose& T_odom_base,
                                        const Matrix6& information) {
  const PredictedMotion predicted = predict(stamp);
  const Pose T_previous_base = T_odom_previous_.inverse() * T_odom_base;
  const bool is_told = information.topLeftCorner<3, 3>().trace() > kLeastInformation;
  if (predicted.is_known)
    filter_.update(predicted.T_previous_base, predicted.seconds,
                   log(predicted.T_previous_base.inverse() * T_previous_base), information);
  else if (observed_ > 0)
    filter_.start(predicted.seconds_untold, information);
  if (observed_ > 0 && is_told)
    motion_ = ConstantMotion(log(T_odom_told_.inverse() * T_odom_base) / predicted.seconds_untold);
  if (observed_ == 0 || is_told) {
    told_stamp_ = stamp;
    T_odom_told_ = T_odom_base;
  }
  T_odom_previous_ = T_odom_base;
  previous_stamp_ = stamp;
  observed_ = std::min(observed_ + 1, 2);
}

void ConstantVelocityPredictor::forget() {
  observed_ = 0;
  motion_ = ConstantMotion();
  filter_ = VelocityFilter();
}

}  // namespace revisit_slam
