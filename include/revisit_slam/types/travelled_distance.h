// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace revisit_slam {

/// How far a platform has come. Estimates of one that stands still jitter; what stays within the
/// dead band around where it last counted is no motion.
class TravelledDistance {
 public:
  /// m. Above the jitter of an odometry at rest, below a step.
  static constexpr double kDeadBand = 0.1;

  void start(const Eigen::Vector3d& position) {
    metres_ = 0.0;
    goOnFrom(position);
  }

  /// The way there does not count.
  void goOnFrom(const Eigen::Vector3d& position) { counted_ = position; }

  void go(const Eigen::Vector3d& position) {
    const double step = (position - counted_).norm();
    if (step <= kDeadBand) return;
    metres_ += step;
    counted_ = position;
  }

  double metres() const { return metres_; }
  /// With what would be travelled to there.
  double metresTo(const Eigen::Vector3d& position) const {
    return metres_ + (position - counted_).norm();
  }

 private:
  Eigen::Vector3d counted_ = Eigen::Vector3d::Zero();
  double metres_ = 0.0;
};

}  // namespace revisit_slam
