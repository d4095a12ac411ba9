// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>

#include "revisit_slam/datasets/dataset_options.h"

namespace revisit_slam {

/// The points of a velodyne .bin file of KITTI.
sensor_msgs::PointCloud2 readKittiPoints(const std::string& path, const DatasetOptions& options);

}  // namespace revisit_slam
