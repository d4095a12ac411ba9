// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/time.h>

#include "revisit_slam/core/pose.h"
#include "revisit_slam/core/stamp.h"

namespace revisit_slam {

inline Stamp toStamp(const ros::Time& time) {
  return {static_cast<std::int64_t>(time.sec) * 1'000'000'000 + time.nsec};
}

/// ROS 1 has no time before the epoch: such stamps become zero.
inline ros::Time toRosTime(Stamp stamp) {
  ros::Time time;
  if (stamp.nanoseconds > 0) time.fromNSec(static_cast<std::uint64_t>(stamp.nanoseconds));
  return time;
}

Pose toPose(const geometry_msgs::Transform& transform);
geometry_msgs::Transform toTransformMessage(const Pose& T);
geometry_msgs::Pose toPoseMessage(const Pose& T);

}  // namespace revisit_slam
