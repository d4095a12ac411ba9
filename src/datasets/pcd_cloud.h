// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/input/point_cloud.h"

namespace revisit_slam {

/// A PCD file (ascii, binary or binary_compressed), with all its fields but padding and integers of
/// 8 bytes. PCL's own reader trusts what a damaged header announces.
/// @throws DatasetError naming the file
PointCloud readPcd(const std::string& path);

bool hasField(const PointCloud& cloud, const std::string& name);
/// From the list of fields; its bytes stay.
void dropField(PointCloud& cloud, const std::string& name);

}  // namespace revisit_slam
