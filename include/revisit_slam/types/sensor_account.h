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
  bool is_silent = false;                             ///< sweeps do not wait for it
};

}  // namespace revisit_slam
