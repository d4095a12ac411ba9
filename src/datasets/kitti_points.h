// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/datasets/dataset_options.h"
#include "revisit_slam/input/point_cloud.h"

namespace revisit_slam {

/// The points of a velodyne .bin file of KITTI.
PointCloud readKittiPoints(const std::string& path, const DatasetOptions& options);

}  // namespace revisit_slam
