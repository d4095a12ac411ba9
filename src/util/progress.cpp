// SPDX-License-Identifier: MIT
#include "revisit_slam/util/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace revisit_slam {
namespace {

constexpr std::size_t kBarWidth = 32;
constexpr double kRedrawSeconds = 0.1;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Progress::Progress(std::string title, std::string unit, std::size_t total, bool quiet)
    : title_(std::move(title)),
      unit_(std::move(unit)),
      total_(total),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::update(std::size_t done) {
  done_ = done;
  if (quiet_ || total_ == 0) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t tenths = 10 * done / total_;
  if (terminal_) {
    if (done < total_ && secondsSince(last_drawn_) < kRedrawSeconds) return;
    last_drawn_ = Clock::now();
    const std::size_t filled = std::min(kBarWidth, kBarWidth * done / total_);
    const std::string bar = std::string(filled, '=') + std::string(kBarWidth - filled, ' ');
    std::fprintf(stderr, "\r%s [%s] %s\033[K", title_.c_str(), bar.c_str(), rate(done).c_str());
  } else if (tenths > tenths_said_) {
    tenths_said_ = tenths;
    std::fprintf(stderr, "%s: %s\n", title_.c_str(), rate(done).c_str());
  }
}

void Progress::say(const std::string& line) {
  if (quiet_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  clearBar();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Progress::finish() {
  if (quiet_) return;
  clearBar();
  const double seconds = secondsSince(start_);
  std::fprintf(stderr, "%s: %zu %s in %.1f s, %.1f %s/s\n", title_.c_str(), done_, unit_.c_str(),
               seconds, static_cast<double>(done_) / std::max(seconds, 1e-9), unit_.c_str());
}

std::string Progress::rate(std::size_t done) const {
  const double per_second = static_cast<double>(done) / std::max(secondsSince(start_), 1e-9);
  const double left =
      static_cast<double>(total_ - std::min(done, total_)) / std::max(per_second, 1e-9);
  char text[128];
  std::snprintf(text, sizeof(text), "%zu/%zu %s, %.1f/s, %.0f s left", done, total_, unit_.c_str(),
                per_second, left);
  return text;
}

void Progress::clearBar() const {
  if (terminal_) std::fprintf(stderr, "\r\033[K");
}

}  // namespace revisit_slam
