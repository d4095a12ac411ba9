// SPDX-License-Identifier: MIT
#include "revisit_slam/input/number_type.h"

namespace revisit_slam {

NumberType numberTypeFromPointField(std::uint8_t datatype) {
  const bool known = datatype <= static_cast<std::uint8_t>(NumberType::float64);
  return known ? static_cast<NumberType>(datatype) : NumberType::unknown;
}

std::size_t sizeOf(NumberType type) {
  std::size_t size = 0;
  withNumberType(type, [&size](auto zero) { size = sizeof(zero); });
  return size;
}

bool isInteger(NumberType type) {
  return type != NumberType::unknown && type != NumberType::float32 && type != NumberType::float64;
}

const char* toString(NumberType type) {
  switch (type) {
    case NumberType::int8:
      return "int8";
    case NumberType::uint8:
      return "uint8";
    case NumberType::int16:
      return "int16";
    case NumberType::uint16:
      return "uint16";
    case NumberType::int32:
      return "int32";
    case NumberType::uint32:
      return "uint32";
    case NumberType::float32:
      return "float32";
    case NumberType::float64:
      return "float64";
    case NumberType::unknown:
      break;
  }
  return "unknown type";
}

}  // namespace revisit_slam
