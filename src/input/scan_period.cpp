// SPDX-License-Identifier: MIT
#include "revisit_slam/input/scan_period.h"

#include <algorithm>
#include <vector>

namespace revisit_slam {

void ScanPeriod::add(Stamp stamp) {
  constexpr double shortest = 1e-3;
  constexpr double longest = 2.0;
  if (previous_) {
    const double interval = secondsBetween(*previous_, stamp);
    if (shortest <= interval && interval <= longest) intervals_.push_back(interval);
    if (intervals_.size() > max_intervals_) intervals_.pop_front();
  }
  previous_ = stamp;
}

double ScanPeriod::seconds() const {
  if (intervals_.empty()) return 0.1;
  std::vector<double> sorted(intervals_.begin(), intervals_.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[(sorted.size() - 1) / 2];
}

}  // namespace revisit_slam
