// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/adaptive_threshold.h"

#include <cmath>

namespace revisit_slam {

AdaptiveThreshold::AdaptiveThreshold(const AdaptiveThresholdConfig& config, double max_range)
    : min_motion_(config.min_motion),
      max_range_(max_range),
      sum_of_squares_(config.initial * config.initial) {}

double AdaptiveThreshold::sigma() const {
  return std::sqrt(sum_of_squares_ / samples_);
}

void AdaptiveThreshold::update(const Pose& deviation) {
  const double error =
      deviation.translation.norm() + 2.0 * max_range_ * std::sin(0.5 * deviation.angle());
  if (error <= min_motion_) return;
  sum_of_squares_ += error * error;
  ++samples_;
}

}  // namespace revisit_slam
