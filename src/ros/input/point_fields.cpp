// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/point_fields.h"

#include <utility>

#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {

PointMessage viewOf(const sensor_msgs::PointCloud2& cloud) {
  PointMessage message;
  message.header_stamp = toStamp(cloud.header.stamp);
  message.frame_id = cloud.header.frame_id;
  PointView& view = message.points;
  view.data = cloud.data.data();
  view.size = cloud.data.size();
  view.width = cloud.width;
  view.height = cloud.height;
  view.point_step = cloud.point_step;
  view.row_step = cloud.row_step;
  view.swapped = cloud.is_bigendian != 0;
  for (const auto& field : cloud.fields) {
    view.fields.push_back({field.name, numberTypeFromPointField(field.datatype), field.offset});
  }
  return message;
}

sensor_msgs::PointCloud2 toPointCloud2(PointCloud cloud) {
  sensor_msgs::PointCloud2 message;
  message.header.stamp = toRosTime(cloud.stamp);
  message.header.frame_id = cloud.frame_id;
  message.width = static_cast<std::uint32_t>(cloud.width);
  message.height = static_cast<std::uint32_t>(cloud.height);
  message.point_step = static_cast<std::uint32_t>(cloud.point_step);
  message.row_step = message.width * message.point_step;
  for (const PointField& field : cloud.fields) {
    sensor_msgs::PointField& added = message.fields.emplace_back();
    added.name = field.name;
    added.offset = static_cast<std::uint32_t>(field.offset);
    added.datatype = static_cast<std::uint8_t>(field.type);
    added.count = static_cast<std::uint32_t>(field.count);
  }
  message.data = std::move(cloud.data);
  return message;
}

}  // namespace revisit_slam
