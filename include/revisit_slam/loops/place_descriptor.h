// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

// The bits of a word are counted by one instruction that not all x86-64 processors have. The loader
// picks the version of a function marked so that the processor can run; both give the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__POPCNT__)
#define REVISIT_SLAM_COUNTS_BITS __attribute__((target_clones("popcnt", "default")))
#else
#define REVISIT_SLAM_COUNTS_BITS
#endif

namespace revisit_slam {

/// 256 binary comparisons around a pixel (ORB).
using Descriptor = std::array<std::uint64_t, 4>;

/// Bits in which two descriptors differ.
inline int differingBits(const Descriptor& a, const Descriptor& b) {
  return __builtin_popcountll(a[0] ^ b[0]) + __builtin_popcountll(a[1] ^ b[1]) +
         __builtin_popcountll(a[2] ^ b[2]) + __builtin_popcountll(a[3] ^ b[3]);
}

}  // namespace revisit_slam
