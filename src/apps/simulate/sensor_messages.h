// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>

#include "options.h"

namespace revisit_slam::simulation {

/// Covariances of all zeros: not known.
nav_msgs::Odometry messageOf(const WheelReading& reading);
sensor_msgs::Imu messageOf(const ImuSample& sample);
sensor_msgs::NavSatFix messageOf(const GnssSample& sample);

/// Where the sensors are on base_link, on /tf_static.
void writeMountings(rosbag::Bag& bag, const Options& o, Stamp start);

}  // namespace revisit_slam::simulation
