// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace revisit_slam {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "ROS serialises numbers in this order");

/// A number at any address: fields need not be aligned. `swapped`: it is big-endian.
template <typename T, bool swapped>
T loadNumber(const std::uint8_t* address) {
  std::uint8_t bytes[sizeof(T)];
  std::memcpy(bytes, address, sizeof(T));
  if constexpr (swapped) std::reverse(bytes, bytes + sizeof(T));
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return number;
}

}  // namespace revisit_slam
