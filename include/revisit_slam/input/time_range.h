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
  /// How many times are finite and within; the range is meaningful from one on.
  std::size_t finite = 0;

  double span() const { return last - first; }
  bool contains(double time) const { return first <= time && time <= last; }

  /// Of all finite times.
  static TimeRange of(const std::vector<double>& times);
  /// Without times far from the bulk of the others, such as the 0 or 0xffffffff of points without a
  /// time: up to a tenth of all before and as many behind.
  static TimeRange ofBulk(const std::vector<double>& times);
};

}  // namespace revisit_slam
