// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "revisit_slam/input/point_cloud.h"
#include "revisit_slam/ros/input/point_message.h"

namespace revisit_slam {

/// The header, bytes and fields of a message as they are announced: not yet checked. The view is
/// into the message and valid as long as that is.
PointMessage viewOf(const sensor_msgs::PointCloud2& cloud);

/// The bytes and fields as they are, handed on without a copy when the cloud is moved in.
sensor_msgs::PointCloud2 toPointCloud2(PointCloud cloud);

}  // namespace revisit_slam
