// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "revisit_slam/input/point_view.h"
#include "revisit_slam/input/time_source.h"

namespace revisit_slam {

/// Why scans have no point times; `undecided` before the first one.
enum class TimeFault {
  none,
  undecided,
  switched_off,
  no_field,
  no_values,
  constant,
  implausible,
  contradicts_parameter,
};

/// What a user can do about it; empty where nothing has to be done.
const char* remedyOf(TimeFault fault);

struct TimeDecision {
  std::optional<TimeSource> source;
  TimeFault fault = TimeFault::none;
  /// The fault in words, with the numbers behind it.
  std::string reason;
};

/// What one sweep says about its time field. The unit is the one in which the sweep lasts as long
/// as sweeps do (1 ms to 1 s, which leaves one unit only); a header stamp that the times are close
/// to and the name of the field come before that. The origin is what the times are near: the
/// header stamp or zero. `prior` is what earlier sweeps said: it stays as long as it is possible.
TimeDecision decideTimeSource(const PointField& field, const TimeRange& range, Stamp header,
                              const TimeOverrides& overrides,
                              const std::optional<TimeSource>& prior);

}  // namespace revisit_slam
