// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/ColorRGBA.h>

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

/// One cloud of all parts with fields x, y, z, rgb, undated. Of more than `max_points` as many are
/// picked evenly.
sensor_msgs::PointCloud2 toColouredCloud(const std::vector<CloudPart>& parts,
                                         const std::string& frame, int max_points);

}  // namespace revisit_slam
