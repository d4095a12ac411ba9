// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace revisit_slam {

/// What became of every message and point received: received = processed + joined + dropped, by
/// reason, and those that wait.
struct ScanAccount {
  std::size_t received = 0;
  std::size_t processed = 0;
  std::size_t at_rest = 0;  ///< of those processed, left out of maps and graph
  /// Messages that went into the sweep of a later one.
  std::size_t joined = 0;
  std::map<std::string, std::size_t> dropped;

  std::size_t points_received = 0;
  std::map<std::string, std::size_t> points_dropped;

  std::size_t droppedInAll() const {
    std::size_t sum = 0;
    for (const auto& [reason, count] : dropped) sum += count;
    return sum;
  }
};

}  // namespace revisit_slam
