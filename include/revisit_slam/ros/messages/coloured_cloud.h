// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/ColorRGBA.h>

#include <cstddef>
#include <string>
#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Points, where they are, and how they are to be shown.
struct CloudPart {
  const Points* points;
  Pose T_map_points;
  std_msgs::ColorRGBA colour;
};

/// A cloud with fields x, y, z, rgb, undated, that is made part by part.
class ColouredCloud {
 public:
  /// Of more than `max_points` of `total` points as many are picked evenly.
  ColouredCloud(const std::string& frame, std::size_t total, int max_points);

  void add(const CloudPart& part);
  sensor_msgs::PointCloud2 take();

 private:
  sensor_msgs::PointCloud2 cloud_;
  std::size_t total_, shown_, index_ = 0;
};

/// One cloud of all parts.
sensor_msgs::PointCloud2 toColouredCloud(const std::vector<CloudPart>& parts,
                                         const std::string& frame, int max_points);

}  // namespace revisit_slam
