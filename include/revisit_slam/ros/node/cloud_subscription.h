// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <string>

namespace revisit_slam {

/// Subscribes to clouds, without a limit to how many may wait. Of one from another process the
/// sizes that it announces are checked before memory is taken for them: `on_damaged` hears why one
/// is none. From the same process clouds come as they are, without a copy.
ros::Subscriber subscribeToClouds(
    ros::NodeHandle& node, const std::string& topic,
    const std::function<void(const ros::MessageEvent<const sensor_msgs::PointCloud2>&)>& on_cloud,
    const std::function<void(const std::string&)>& on_damaged);

}  // namespace revisit_slam
