// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace revisit_slam {

/// Progress on stderr: a bar with rate and time left on a terminal, a plain line every ten per cent
/// elsewhere. Any thread may speak.
class Progress {
 public:
  /// `unit` in the plural: "scans".
  Progress(std::string title, std::string unit, std::size_t total, bool quiet);

  void update(std::size_t done);
  /// A line of its own that does not tear the bar.
  void say(const std::string& line);
  void finish();

 private:
  std::string rate(std::size_t done) const;
  void clearBar() const;

  std::mutex mutex_;  // guards the terminal

  using Clock = std::chrono::steady_clock;
  std::string title_, unit_;
  std::size_t total_;
  bool quiet_, terminal_;
  Clock::time_point start_ = Clock::now(), last_drawn_{};
  std::size_t done_ = 0, tenths_said_ = 0;
};

}  // namespace revisit_slam
