// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Estimates sigma, the expected error of the motion prediction, from how far registrations moved
/// the predictions (KISS-ICP Sec. III-D, Eq. 5-6).
class AdaptiveThreshold {
 public:
  /// `max_range` in metres: the distance at which a rotation is felt as a displacement.
  AdaptiveThreshold(const AdaptiveThresholdConfig& config, double max_range);

  void setMaxRange(double max_range) { max_range_ = max_range; }

  /// Metres.
  double sigma() const;

  /// `deviation` = T_odom_predicted^-1 * T_odom_base.
  void update(const Pose& deviation);

 private:
  double min_motion_;
  double max_range_;
  double sum_of_squares_;
  int samples_ = 1;
};

}  // namespace revisit_slam
