// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <topic_tools/shape_shifter.h>

#include <string>
#include <variant>

#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A message with a scan, as it came.
struct ArrivedScan {
  using Cloud = sensor_msgs::PointCloud2::ConstPtr;
  using Bytes = topic_tools::ShapeShifter::ConstPtr;  ///< of a type that is found out

  std::variant<Cloud, Bytes> message;
  Stamp arrival;
  std::size_t sensor = 0;  ///< number of its topic among input/topics

  /// Empty where it has no header.
  std::string frame() const;
  ScanReading readBy(ScanReader& reader) const;
};

}  // namespace revisit_slam
