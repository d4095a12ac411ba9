// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "support/point_cloud_builder.h"
#include "support/synthetic_drive.h"

namespace revisit_slam {

/// The message of a sensor that measured this scan; its header stamp is that of the last point.
inline sensor_msgs::PointCloud2 toCloud(const Scan& scan, bool big_endian = false) {
  std::vector<TestPoint> points(scan.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f& p = scan.points[i];
    points[i] = {p.x(), p.y(), p.z(), scan.times[i]};
  }
  PointCloudBuilder builder(scan.stamp.nanoseconds);
  if (big_endian) builder.bigEndian();
  return builder.xyz().field("time", sensor_msgs::PointField::FLOAT32).build(points);
}

inline std::vector<sensor_msgs::PointCloud2> toClouds(const Drive& drive) {
  std::vector<sensor_msgs::PointCloud2> clouds;
  for (const Scan& scan : drive.scans) clouds.push_back(toCloud(scan));
  return clouds;
}

/// Messages that cannot be used, all of the same stamp.
struct BadClouds {
  explicit BadClouds(const sensor_msgs::PointCloud2& good)
      : empty(good), all_nan(good), no_point_step(good), truncated(good), no_y(good) {
    empty.width = empty.row_step = 0;
    empty.data.clear();
    std::fill(all_nan.data.begin(), all_nan.data.end(), 0xff);
    no_point_step.point_step = 0;
    truncated.data.resize(truncated.data.size() / 2);
    no_y.fields[1].name = "other";
  }

  sensor_msgs::PointCloud2 empty, all_nan, no_point_step, truncated, no_y;
};

}  // namespace revisit_slam
