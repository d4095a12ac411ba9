// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/stamp_gate.h"

#include <algorithm>
#include <utility>

namespace revisit_slam {
namespace {

/// Periods between two scans that are no gap: one or two scans may be missing.
constexpr double kPeriods = 3.5;
/// The longest period fades by this factor a scan. Several sensors take turns with unequal periods.
constexpr double kFading = 0.9;

}  // namespace

std::vector<StampGate::Decision> StampGate::take(ScanReading reading) {
  std::vector<Decision> decisions;
  const Stamp stamp = reading.scan->stamp;
  if (ahead_) judgeAhead(stamp, decisions);
  if (last_ && stamp == *last_) {
    decisions.push_back({std::move(reading), "duplicate stamp", {}});
  } else if (last_ && stamp < *last_) {
    hold(std::move(reading), decisions);
  } else {
    refuseBehind(decisions);
    if (last_ && isGap(secondsBetween(*last_, stamp))) {
      ahead_ = std::move(reading);
    } else {
      pass(std::move(reading), decisions);
    }
  }
  return decisions;
}

bool StampGate::isGap(double seconds) const {
  if (seconds > max_gap_) return true;
  return !gap_is_expected_ && (period_ > 0.0 && seconds > kPeriods * period_);
}

/// Time goes on from there: a gap. Else the stamp alone was ahead.
void StampGate::judgeAhead(Stamp next, std::vector<Decision>& decisions) {
  ScanReading held = std::move(*ahead_);
  ahead_.reset();
  if (held.scan->stamp <= next) return pass(std::move(held), decisions);
  decisions.push_back({std::move(held), "stamp ahead of the next one", {}});
}

void StampGate::hold(ScanReading reading, std::vector<Decision>& decisions) {
  if (!behind_.empty() && reading.scan->stamp <= behind_.back().scan->stamp)
    refuseBehind(decisions);
  behind_.push_back(std::move(reading));
  if (behind_.size() < restart_after_) return;
  const double went_back = secondsBetween(behind_.front().scan->stamp, *last_);
  for (ScanReading& held : std::exchange(behind_, {})) pass(std::move(held), decisions);
  decisions[decisions.size() - restart_after_].went_back = went_back;
}

void StampGate::refuseBehind(std::vector<Decision>& decisions) {
  for (ScanReading& held : std::exchange(behind_, {}))
    decisions.push_back({std::move(held), "time went back", {}});
}

void StampGate::pass(ScanReading reading, std::vector<Decision>& decisions) {
  if (last_ && *last_ < reading.scan->stamp)
    period_ = std::max(secondsBetween(*last_, reading.scan->stamp), kFading * period_);
  last_ = reading.scan->stamp;
  gap_is_expected_ = false;
  decisions.push_back({std::move(reading), "", {}});
}

std::vector<StampGate::Decision> StampGate::flush() {
  std::vector<Decision> decisions;
  refuseBehind(decisions);
  if (ahead_) pass(std::move(*std::exchange(ahead_, std::nullopt)), decisions);
  return decisions;
}

void StampGate::restart() {
  last_.reset();
  period_ = 0.0;
  ahead_.reset();
  behind_.clear();
}

}  // namespace revisit_slam
