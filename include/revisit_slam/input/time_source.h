// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "revisit_slam/input/scan_input_config.h"
#include "revisit_slam/input/time_range.h"
#include "revisit_slam/input/time_unit.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

enum class TimeOrigin {
  /// Since the epoch, on the clock of the header stamps.
  absolute,
  /// Since the header stamp.
  relative,
  /// Neither: a sensor that is not synchronised, or counts from its start or the last full hour.
  own_clock,
};

/// An instant of a sweep; `time_zero` is where the times of its points are 0.
enum class SweepInstant { time_zero, first, middle, last };

/// How the numbers in a time field become instants.
struct TimeSource {
  TimeUnit unit = TimeUnit::s;
  TimeOrigin origin = TimeOrigin::relative;
  /// What the header stamp belongs to; of no effect for absolute times.
  SweepInstant header = SweepInstant::time_zero;
};

inline bool operator==(const TimeSource& a, const TimeSource& b) {
  return a.unit == b.unit && a.origin == b.origin && a.header == b.header;
}

/// What the parameters fix; the rest is decided from the data.
struct TimeOverrides {
  std::optional<TimeUnit> unit;
  std::optional<TimeOrigin> origin;
  std::optional<SweepInstant> header;

  /// Throws ParameterError on a word that is no choice.
  static TimeOverrides from(const ScanInputConfig& config);
};

const char* toString(TimeOrigin origin);
const char* toString(SweepInstant instant);

/// The instant of the last point, in whole nanoseconds.
Stamp stampOfLastPoint(const TimeSource& source, const TimeRange& range, Stamp header);

}  // namespace revisit_slam
