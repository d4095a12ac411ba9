// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/ros/input/point_message.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// CustomMsg of livox_ros_driver and livox_ros_driver2, which have the same layout, without need of
/// either package.
struct LivoxCustomMsg : PointMessage {
  /// The instant from which offset_time counts, on the sensor's clock.
  Stamp timebase;
};

bool isLivoxCustomMsg(const std::string& datatype);

/// Whether messages of this definition have the layout that parseLivoxCustomMsg() reads.
bool hasLivoxLayout(const std::string& md5sum, const std::string& definition);

/// Throws std::runtime_error unless the bytes are exactly one message.
LivoxCustomMsg parseLivoxCustomMsg(const std::vector<std::uint8_t>& bytes);

}  // namespace revisit_slam
