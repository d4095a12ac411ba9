// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// The period of the scans: the median of the latest intervals between their stamps, so that a
/// dropped scan or a jump of the clock does not change it.
class ScanPeriod {
 public:
  void add(Stamp stamp);
  /// Until two stamps are known: that of a sensor turning at 10 Hz.
  double seconds() const;

 private:
  static constexpr std::size_t max_intervals_ = 11;
  std::optional<Stamp> previous_;
  std::deque<double> intervals_;
};

}  // namespace revisit_slam
