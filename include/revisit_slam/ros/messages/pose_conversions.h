// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/time.h>

#include <algorithm>
#include <cstdint>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

inline Stamp toStamp(const ros::Time& time) {
  return {static_cast<std::int64_t>(time.sec) * 1'000'000'000 + time.nsec};
}

/// ROS 1 has no time before the epoch nor after 32 bits of seconds: such stamps become its ends.
/// The last minute is left out, as every tf2 listener adds to stamps and throws where that
/// overflows.
inline ros::Time toRosTime(Stamp stamp) {
  constexpr std::int64_t last = (std::int64_t{0xffffffff} - 60) * 1'000'000'000;
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(std::clamp<std::int64_t>(stamp.nanoseconds, 0, last)));
  return time;
}

Pose toPose(const geometry_msgs::Transform& transform);
geometry_msgs::Transform toTransformMessage(const Pose& T);
geometry_msgs::Pose toPoseMessage(const Pose& T);

}  // namespace revisit_slam
