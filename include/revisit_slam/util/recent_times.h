// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace revisit_slam {

/// Durations of the newest pieces of work: whether it keeps up, at a glance.
class RecentTimes {
 public:
  static constexpr std::size_t kRemembered = 1000;

  void add(double milliseconds);
  /// "7.1, 18.6, 62.3 of 1000": median, 99th percentile and largest in milliseconds, and of how
  /// many.
  std::string summary() const;
  /// ms; 0: none yet.
  double median() const;

 private:
  std::vector<double> milliseconds_;
  std::size_t next_ = 0;
};

}  // namespace revisit_slam
