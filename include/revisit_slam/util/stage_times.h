// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <utility>
#include <vector>

namespace revisit_slam {

/// Wall time of the named steps of one scan's way, in order, milliseconds.
using StageTimes = std::vector<std::pair<const char*, double>>;

/// Splits time into stages: `stage("name")` closes the stage that ran since the previous call.
class StageClock {
 public:
  void stage(const char* name) {
    const auto now = Clock::now();
    times_.emplace_back(name, std::chrono::duration<double, std::milli>(now - last_).count());
    last_ = now;
  }
  StageTimes times() const { return times_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  StageTimes times_;
};

}  // namespace revisit_slam
