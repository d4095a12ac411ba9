// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace revisit_slam {

/// An instant in integer nanoseconds since the epoch of the recording. Seconds as double appear
/// only at the edges (files, ROS messages) and in differences, which are small.
struct Stamp {
  std::int64_t nanoseconds = 0;

  static Stamp fromSeconds(double seconds) { return {std::llround(seconds * 1e9)}; }
  double toSeconds() const { return static_cast<double>(nanoseconds) * 1e-9; }

  Stamp plusSeconds(double seconds) const { return {nanoseconds + std::llround(seconds * 1e9)}; }

  friend bool operator==(Stamp a, Stamp b) { return a.nanoseconds == b.nanoseconds; }
  friend bool operator!=(Stamp a, Stamp b) { return a.nanoseconds != b.nanoseconds; }
  friend bool operator<(Stamp a, Stamp b) { return a.nanoseconds < b.nanoseconds; }
  friend bool operator<=(Stamp a, Stamp b) { return a.nanoseconds <= b.nanoseconds; }
  friend bool operator>(Stamp a, Stamp b) { return b < a; }
  friend bool operator>=(Stamp a, Stamp b) { return b <= a; }
};

/// later - earlier, in seconds.
inline double secondsBetween(Stamp earlier, Stamp later) {
  return static_cast<double>(later.nanoseconds - earlier.nanoseconds) * 1e-9;
}

}  // namespace revisit_slam
