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
  using Livox = topic_tools::ShapeShifter::ConstPtr;

  std::variant<Cloud, Livox> message;
  Stamp arrival;

  /// Empty where it has no header.
  std::string frameId() const;
  ScanReading readBy(ScanReader& reader) const;
};

}  // namespace revisit_slam
