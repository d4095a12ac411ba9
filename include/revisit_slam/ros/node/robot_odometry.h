// SPDX-License-Identifier: MIT
#pragma once

#include <tf2_ros/transform_listener.h>

#include <deque>
#include <optional>
#include <string>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// The odometry that the robot broadcasts itself, beside our own: both move the base, each in its
/// frame. For one thread at a time.
class RobotOdometry {
 public:
  /// `odom_frame`: that of the robot.
  explicit RobotOdometry(const std::string& odom_frame) : odom_frame_(odom_frame) {}

  void onScan(Stamp stamp, const Pose& T_own_base, const std::string& base_frame);
  /// Our own odometry starts anew.
  void restart();

  /// The robot's odometry frame in ours, by the newest scan whose stamp TF has reached; nothing
  /// where it has reached none.
  std::optional<Pose> placed();

 private:
  struct Placed {
    Stamp stamp;
    Pose T_own_base;
    std::string base_frame;
  };
  std::optional<Pose> lookUp(const Placed& scan) const;

  const std::string odom_frame_;
  std::deque<Placed> scans_;  // that TF has not reached
  std::optional<Pose> T_own_robot_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
};

}  // namespace revisit_slam
