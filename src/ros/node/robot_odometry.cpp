// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/robot_odometry.h"

#include <ros/console.h>

#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kMostWaiting = 100;  // scans: tf2 keeps 10 s

}  // namespace

void RobotOdometry::onScan(Stamp stamp, const Pose& T_own_base, const std::string& base_frame) {
  scans_.push_back({stamp, T_own_base, base_frame});
  if (scans_.size() > kMostWaiting) scans_.pop_front();
}

void RobotOdometry::restart() {
  scans_.clear();
  T_own_robot_.reset();
}

std::optional<Pose> RobotOdometry::placed() {
  for (std::size_t i = scans_.size(); i-- > 0;) {
    const std::optional<Pose> T_robot_base = lookUp(scans_[i]);
    if (!T_robot_base) continue;
    T_own_robot_ = scans_[i].T_own_base * T_robot_base->inverse();
    scans_.erase(scans_.begin(), scans_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return T_own_robot_;
  }
  if (scans_.size() == kMostWaiting)
    ROS_WARN_THROTTLE(5.0,
                      "no transform from '%s' to '%s' at the stamps of the scans: the map frame "
                      "cannot be placed; broadcast it, or set live/broadcast_odom to true",
                      scans_.back().base_frame.c_str(), odom_frame_.c_str());
  return T_own_robot_;
}

/// At the very stamp: the robot moves on from scan to scan.
std::optional<Pose> RobotOdometry::lookUp(const Placed& scan) const {
  try {
    return toPose(
        buffer_.lookupTransform(odom_frame_, scan.base_frame, toRosTime(scan.stamp)).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace revisit_slam
