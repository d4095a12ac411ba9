// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <string>
#include <vector>

#include "revisit_slam/input/number_type.h"

namespace revisit_slam {

/// One number of a point.
struct RecordField {
  const char* name;
  NumberType type;
};

/// A point in a file: its numbers one after the other, little-endian, without gaps.
using RecordLayout = std::vector<RecordField>;

/// A message whose points are the file's records, byte for byte. @throws DatasetError unless it is
/// a whole number of records.
sensor_msgs::PointCloud2 readRecords(const std::string& path, const RecordLayout& layout);

/// Makes each point longer by the field `t`: nanoseconds from the header stamp.
/// @param times one for each point.
void addTimes(sensor_msgs::PointCloud2& cloud, const std::vector<std::uint32_t>& times);

/// x, y, z and one more float.
const RecordLayout& xyzAndIntensity();

}  // namespace revisit_slam
