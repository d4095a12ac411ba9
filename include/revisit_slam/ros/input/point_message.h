// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/input/load_number.h"
#include "revisit_slam/input/point_view.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// What every message with points has. The view is into the bytes that were parsed.
struct PointMessage {
  Stamp header_stamp;
  std::string frame_id;
  PointView points;
};

/// Reads what ROS serialises (little-endian, packed) and never past the end: throws
/// std::runtime_error instead, before any memory is taken for what a damaged length announces.
class MessageBytes {
 public:
  explicit MessageBytes(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  /// Where the next `count` bytes begin.
  const std::uint8_t* take(std::size_t count);
  template <typename T>
  T number() {
    return loadNumber<T, false>(take(sizeof(T)));
  }
  std::string text();
  /// Into its members of that name.
  void header(PointMessage& message);
  /// Throws when bytes are left.
  void expectEnd() const;

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::size_t next_ = 0;
};

/// sensor_msgs/PointCloud2 without a copy of its data. Throws std::runtime_error unless the bytes
/// are exactly one message.
PointMessage parsePointCloud2(const std::vector<std::uint8_t>& bytes);

}  // namespace revisit_slam
