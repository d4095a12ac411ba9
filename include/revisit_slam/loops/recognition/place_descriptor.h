// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace revisit_slam {

/// 256 binary comparisons around a pixel (ORB).
using Descriptor = std::array<std::uint64_t, 4>;

/// Bits in which two descriptors differ.
inline int differingBits(const Descriptor& a, const Descriptor& b) {
  return __builtin_popcountll(a[0] ^ b[0]) + __builtin_popcountll(a[1] ^ b[1]) +
         __builtin_popcountll(a[2] ^ b[2]) + __builtin_popcountll(a[3] ^ b[3]);
}

}  // namespace revisit_slam
