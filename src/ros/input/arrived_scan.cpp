// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/arrived_scan.h"

namespace revisit_slam {

std::string ArrivedScan::frame() const {
  if (const auto* cloud = std::get_if<Cloud>(&message)) return (**cloud).header.frame_id;
  return frameOf(*std::get<Bytes>(message));
}

ScanReading ArrivedScan::readBy(ScanReader& reader) const {
  ScanReading reading =
      std::visit([&](const auto& pointer) { return reader.read(*pointer, arrival); }, message);
  reading.sensor = sensor;
  return reading;
}

}  // namespace revisit_slam
