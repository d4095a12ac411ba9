// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/rest_detector.h"

#include "revisit_slam/types/travelled_distance.h"

namespace revisit_slam {
namespace {

/// Who stops for less is on the way.
constexpr double kSettlingTime = 3.0;  // s
/// Above the jitter of an odometry at rest.
constexpr double kTurn = 0.02;  // rad

bool isSamePlace(const Pose& T_odom_a, const Pose& T_odom_b) {
  const Pose T_a_b = T_odom_a.inverse() * T_odom_b;
  return T_a_b.translation.norm() <= TravelledDistance::kDeadBand && T_a_b.angle() <= kTurn;
}

}  // namespace

bool RestDetector::repeats(Stamp stamp, const Pose& T_odom_base) {
  if (!rest_ || !isSamePlace(rest_->T_odom_base, T_odom_base)) rest_ = Rest{stamp, T_odom_base};
  const bool has_settled = secondsBetween(rest_->since, stamp) >= kSettlingTime;
  if (has_settled && secondsBetween(counted_, stamp) < interval_) return true;
  counted_ = stamp;
  return false;
}

}  // namespace revisit_slam
