// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_source.h"

#include <array>
#include <cmath>

namespace revisit_slam {
namespace {

template <typename Value, std::size_t n>
std::optional<Value> choice(const char* parameter, const std::string& word,
                            const std::array<Value, n>& values) {
  if (word == "auto") return std::nullopt;
  std::string allowed = "auto";
  for (const Value value : values) {
    if (word == toString(value)) return value;
    allowed += std::string(", ") + toString(value);
  }
  throw ParameterError(std::string(parameter) + " is '" + word + "'; allowed: " + allowed);
}

/// Where the header stamp lies among the times. Relative times count from the sweep's first or to
/// its last instant, so that zero belongs to the sweep even where no point is left there.
double timeOfHeader(const TimeSource& source, const TimeRange& range) {
  const bool relative = source.origin == TimeOrigin::relative;
  const double first = relative ? std::fmin(range.first, 0.0) : range.first;
  const double last = relative ? std::fmax(range.last, 0.0) : range.last;
  switch (source.header) {
    case SweepInstant::time_zero:
      return 0.0;
    case SweepInstant::first:
      return first;
    case SweepInstant::middle:
      return first + 0.5 * (last - first);
    case SweepInstant::last:
      return last;
  }
  return 0.0;
}

}  // namespace

TimeOverrides TimeOverrides::from(const ScanInputConfig& config) {
  constexpr std::array<TimeOrigin, 2> origins{TimeOrigin::absolute, TimeOrigin::relative};
  constexpr std::array<SweepInstant, 3> instants{SweepInstant::first, SweepInstant::middle,
                                                 SweepInstant::last};
  return {choice("time_unit", config.time_unit, time_units),
          choice("time_origin", config.time_origin, origins),
          choice("header_stamp", config.header_stamp, instants)};
}

const char* toString(TimeOrigin origin) {
  switch (origin) {
    case TimeOrigin::absolute:
      return "absolute";
    case TimeOrigin::relative:
      return "relative";
    case TimeOrigin::own_clock:
      return "own clock";
  }
  return "";
}

const char* toString(SweepInstant instant) {
  switch (instant) {
    case SweepInstant::time_zero:
      return "time zero";
    case SweepInstant::first:
      return "first";
    case SweepInstant::middle:
      return "middle";
    case SweepInstant::last:
      return "last";
  }
  return "";
}

Stamp stampOfLastPoint(const TimeSource& source, const TimeRange& range, Stamp header) {
  if (source.origin == TimeOrigin::absolute) return {toNanoseconds(range.last, source.unit)};
  const double after_header = range.last - timeOfHeader(source, range);
  return {header.nanoseconds + toNanoseconds(after_header, source.unit)};
}

}  // namespace revisit_slam
