// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/arrived_scan.h"

namespace revisit_slam {

std::string ArrivedScan::frameId() const {
  if (const auto* cloud = std::get_if<Cloud>(&message)) return (**cloud).header.frame_id;
  return frameOf(*std::get<Livox>(message));
}

ScanReading ArrivedScan::readBy(ScanReader& reader) const {
  return std::visit([&](const auto& pointer) { return reader.read(*pointer, arrival); }, message);
}

}  // namespace revisit_slam
