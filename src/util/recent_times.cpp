// SPDX-License-Identifier: MIT
#include "revisit_slam/util/recent_times.h"

#include <cstdio>

#include "revisit_slam/util/quantile.h"

namespace revisit_slam {

void RecentTimes::add(double milliseconds) {
  if (milliseconds_.size() < kRemembered) {
    milliseconds_.push_back(milliseconds);
  } else {
    milliseconds_[next_++ % kRemembered] = milliseconds;
  }
}

double RecentTimes::median() const {
  return milliseconds_.empty() ? 0.0 : quantile(milliseconds_, 0.5);
}

std::string RecentTimes::summary() const {
  if (milliseconds_.empty()) return "none yet";
  char text[96];
  std::snprintf(text, sizeof(text), "%.1f, %.1f, %.1f of %zu", quantile(milliseconds_, 0.5),
                quantile(milliseconds_, 0.99), quantile(milliseconds_, 1.0), milliseconds_.size());
  return text;
}

}  // namespace revisit_slam
