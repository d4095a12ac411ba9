// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/motion_predictor.h"

#include <algorithm>

namespace revisit_slam {

PredictedMotion ConstantVelocityPredictor::predict(Stamp stamp) const {
  PredictedMotion predicted;
  predicted.seconds = observed_ == 0 ? 0.0 : secondsBetween(previous_stamp_, stamp);
  predicted.is_after_gap = predicted.seconds > max_prediction_time_;
  predicted.is_known = observed_ > 1 && !predicted.is_after_gap;
  predicted.velocity = motion_;
  predicted.T_previous_base = motion_.after(std::min(predicted.seconds, max_prediction_time_));
  return predicted;
}

void ConstantVelocityPredictor::observe(Stamp stamp, const Pose& T_odom_base) {
  const double seconds = observed_ == 0 ? 0.0 : secondsBetween(previous_stamp_, stamp);
  if (seconds > 0.0)
    motion_ = ConstantMotion(log(T_odom_previous_.inverse() * T_odom_base) / seconds);
  T_odom_previous_ = T_odom_base;
  previous_stamp_ = stamp;
  observed_ = std::min(observed_ + 1, 2);
}

}  // namespace revisit_slam
