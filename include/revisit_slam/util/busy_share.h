// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

namespace revisit_slam {

/// The share of the time for which something was busy, from one look to the next.
class BusyShare {
 public:
  using Clock = std::chrono::steady_clock;

  /// `busy_seconds`: that it has been busy so far. @return 0 at the first look.
  double look(double busy_seconds, Clock::time_point now = Clock::now()) {
    const Look last = last_.value_or(Look{now, busy_seconds});
    last_ = Look{now, busy_seconds};
    const double elapsed = std::chrono::duration<double>(now - last.time).count();
    return elapsed > 0.0 ? (busy_seconds - last.busy_seconds) / elapsed : 0.0;
  }

 private:
  struct Look {
    Clock::time_point time;
    double busy_seconds;
  };
  std::optional<Look> last_;
};

}  // namespace revisit_slam
