// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace revisit_slam {

/// The extent of the times of a sweep, in the unit of their field.
struct TimeRange {
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();
  /// How many times are finite; the range is meaningful from one on.
  std::size_t finite = 0;

  double span() const { return last - first; }

  static TimeRange of(const std::vector<double>& times);
};

}  // namespace revisit_slam
