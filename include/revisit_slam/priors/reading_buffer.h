// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <utility>

#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// The newest readings of one sensor in the order of their stamps.
template <typename Reading>
class ReadingBuffer {
 public:
  /// Takes a reading that is newer than all before. Returns why it was dropped, or nullptr. One
  /// that is older by more than kClock is of a clock that was set back: all before are forgotten.
  const char* take(Reading reading) {
    if (!readings_.empty() && reading.stamp <= readings_.back().stamp) {
      if (reading.stamp == readings_.back().stamp) return "duplicate stamp";
      if (secondsBetween(reading.stamp, readings_.back().stamp) < kClock) return "out of order";
      readings_.clear();
    }
    readings_.push_back(std::move(reading));
    if (readings_.size() > kMost) readings_.pop_front();
    return nullptr;
  }

  bool reaches(Stamp stamp) const { return !readings_.empty() && readings_.back().stamp >= stamp; }

  /// The first reading that is not before the stamp, or end().
  auto at(Stamp stamp) const {
    return std::lower_bound(readings_.begin(), readings_.end(), stamp,
                            [](const Reading& a, Stamp b) { return a.stamp < b; });
  }
  auto begin() const { return readings_.begin(); }
  auto end() const { return readings_.end(); }

  /// Keeps the last reading that is not after the stamp, and what follows it.
  void forgetBefore(Stamp stamp) {
    while (readings_.size() > 1 && readings_[1].stamp <= stamp) readings_.pop_front();
  }

  void clear() { readings_.clear(); }
  std::size_t size() const { return readings_.size(); }

 private:
  static constexpr double kClock = 1.0;         // s
  static constexpr std::size_t kMost = 20'000;  // 20 s at 1 kHz: scans do not wait longer

  std::deque<Reading> readings_;
};

}  // namespace revisit_slam
