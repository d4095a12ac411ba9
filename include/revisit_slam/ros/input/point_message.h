// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/input/load_number.h"
#include "revisit_slam/input/point_view.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A message as it was sent, of a type that its sender names.
struct RawMessage {
  std::string datatype, md5sum, definition;
  std::vector<std::uint8_t> bytes;
  Stamp arrival;
  std::size_t sensor = 0;  ///< number of its topic among input/topics
};

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
  explicit MessageBytes(const std::vector<std::uint8_t>& bytes)
      : MessageBytes(bytes.data(), bytes.size()) {}
  MessageBytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

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
  const std::uint8_t* data_;
  const std::size_t size_;
  std::size_t next_ = 0;
};

/// sensor_msgs/PointCloud2 without a copy of its data. Throws std::runtime_error unless the bytes
/// are exactly one message.
PointMessage parsePointCloud2(MessageBytes reader);

}  // namespace revisit_slam
