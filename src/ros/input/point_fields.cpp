// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/point_fields.h"

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

}  // namespace revisit_slam
