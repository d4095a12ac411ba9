// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// Tells which scans of a base that stands still need no place in maps and graph: they say what
/// those before have said, and hours of them would fill the memory.
class RestDetector {
 public:
  /// `interval`: s between scans that count although the base rests; 0: all do.
  explicit RestDetector(double interval) : interval_(interval) {}

  /// Whether the base has rested for a while and the last scan that counts is less than the
  /// interval old; otherwise this one counts. Stamps ascend.
  bool repeats(Stamp stamp, const Pose& T_odom_base);

 private:
  struct Rest {
    Stamp since;
    Pose T_odom_base;
  };

  double interval_;
  std::optional<Rest> rest_;
  Stamp counted_;
};

}  // namespace revisit_slam
