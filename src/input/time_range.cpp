// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_range.h"

#include <cmath>

namespace revisit_slam {

TimeRange TimeRange::of(const std::vector<double>& times) {
  TimeRange range;
  double first = range.first;  // in registers: through the struct the loop takes twice as long
  double last = range.last;
  for (const double time : times) {
    if (!std::isfinite(time)) continue;
    first = time < first ? time : first;
    last = time > last ? time : last;
    ++range.finite;
  }
  range.first = first;
  range.last = last;
  return range;
}

}  // namespace revisit_slam
