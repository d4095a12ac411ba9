// SPDX-License-Identifier: MIT
#pragma once

#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

namespace revisit_slam {

/// Records the clouds 0.1 s after one another, whatever their own stamps are.
inline void writeScanBag(const std::string& path,
                         const std::vector<sensor_msgs::PointCloud2>& clouds,
                         const std::string& topic = "/points") {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  ros::Time received = clouds.front().header.stamp;
  for (const sensor_msgs::PointCloud2& cloud : clouds) {
    bag.write(topic, received, cloud);
    received += ros::Duration(0.1);
  }
}

}  // namespace revisit_slam
