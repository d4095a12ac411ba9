// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace revisit_slam {

/// What became of the messages and points of one of several sensors.
struct SensorAccount {
  std::size_t messages = 0;
  std::size_t points = 0;                             ///< that went into sweeps
  std::map<std::string, std::size_t> points_dropped;  ///< by reason
  // Sweeps do not wait for it:
  bool is_silent = false;  ///< it sends nothing
  bool is_late = false;    ///< it sends, but too late, or by another clock
  double behind = 0.0;     ///< s, its last message behind the newest of the others; below 0: ahead
};

}  // namespace revisit_slam
