// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace revisit_slam {

/// The types of numbers in a point; the values are those of sensor_msgs/PointField.
enum class NumberType : std::uint8_t {
  unknown = 0,
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  float32 = 7,
  float64 = 8,
};

/// `unknown` for a value that PointField does not define.
NumberType numberTypeFromPointField(std::uint8_t datatype);
/// In bytes; 0 for `unknown`.
std::size_t sizeOf(NumberType type);
bool isInteger(NumberType type);
const char* toString(NumberType type);

/// Calls `action` with a zero of that type, so that the type is chosen once and not per point.
/// Does nothing for `unknown`.
template <typename Action>
void withNumberType(NumberType type, Action&& action) {
  switch (type) {
    case NumberType::int8:
      return action(std::int8_t{});
    case NumberType::uint8:
      return action(std::uint8_t{});
    case NumberType::int16:
      return action(std::int16_t{});
    case NumberType::uint16:
      return action(std::uint16_t{});
    case NumberType::int32:
      return action(std::int32_t{});
    case NumberType::uint32:
      return action(std::uint32_t{});
    case NumberType::float32:
      return action(float{});
    case NumberType::float64:
      return action(double{});
    case NumberType::unknown:
      return;
  }
}

}  // namespace revisit_slam
