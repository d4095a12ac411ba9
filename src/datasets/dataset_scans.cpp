// SPDX-License-Identifier: MIT
#include "revisit_slam/datasets/dataset_scans.h"

#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {

sensor_msgs::PointCloud2 DatasetScans::read(std::size_t index) const {
  sensor_msgs::PointCloud2 cloud = readPoints(index);
  cloud.header.seq = static_cast<std::uint32_t>(index);
  cloud.header.stamp = toRosTime(scans_[index].stamp);
  cloud.header.frame_id = frame_;
  return cloud;
}

}  // namespace revisit_slam
