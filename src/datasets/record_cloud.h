// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/input/number_type.h"
#include "revisit_slam/input/point_cloud.h"

namespace revisit_slam {

/// One number of a point.
struct RecordField {
  const char* name;
  NumberType type;
};

/// A point in a file: its numbers one after the other, little-endian, without gaps.
using RecordLayout = std::vector<RecordField>;

/// A cloud whose points are the file's records, byte for byte. @throws DatasetError unless it is
/// a whole number of records.
PointCloud readRecords(const std::string& path, const RecordLayout& layout);

/// Makes each point longer by the field `t`: nanoseconds from the stamp of the scan.
/// @param times one for each point.
void addTimes(PointCloud& cloud, const std::vector<std::uint32_t>& times);

/// x, y, z and one more float.
const RecordLayout& xyzAndIntensity();

}  // namespace revisit_slam
