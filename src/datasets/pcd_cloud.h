// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>

namespace revisit_slam {

/// A PCD file (ascii, binary or binary_compressed) as a message, with all its fields but padding
/// and integers of 8 bytes. PCL's own reader trusts what a damaged header announces.
/// @throws DatasetError naming the file
sensor_msgs::PointCloud2 readPcd(const std::string& path);

bool hasField(const sensor_msgs::PointCloud2& cloud, const std::string& name);
/// From the list of fields; its bytes stay.
void dropField(sensor_msgs::PointCloud2& cloud, const std::string& name);

}  // namespace revisit_slam
