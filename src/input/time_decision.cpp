// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_decision.h"

#include <algorithm>
#include <cmath>

#include "revisit_slam/input/time_description.h"
#include "revisit_slam/input/time_fields.h"

namespace revisit_slam {
namespace {

constexpr double shortest_sweep = 1e-3;
constexpr double longest_sweep = 1.0;
/// What a sweep may last where something else than its duration speaks for the unit.
constexpr double shortest_possible = 1e-5;
constexpr double longest_possible = 2.0;
/// Times that are so near to an instant, in seconds, count from it.
constexpr double same_clock = 1.0;
/// Clocks of the same epoch, whatever leap seconds or drift are between them.
constexpr double same_epoch = 3600.0;
/// Fewer times than this may be equal by chance.
constexpr std::size_t many_times = 100;

/// Seconds from an instant (in seconds) to the nearest one of the sweep.
double gapTo(double instant, const TimeRange& range, TimeUnit unit) {
  const double first = range.first * secondsIn(unit);
  const double last = range.last * secondsIn(unit);
  return std::max({0.0, first - instant, instant - last});
}

bool lasts(const TimeRange& range, TimeUnit unit, double shortest, double longest) {
  const double duration = range.span() * secondsIn(unit);
  return shortest <= duration && duration < longest;
}

bool isNearHeader(const TimeRange& range, TimeUnit unit, Stamp header) {
  const double stamp = header.toSeconds();
  return stamp > 2 * same_epoch && gapTo(stamp, range, unit) <= same_epoch;
}

std::optional<TimeUnit> unitOf(const PointField& field, const TimeRange& range, Stamp header) {
  for (const TimeUnit unit : time_units) {
    const bool possible = lasts(range, unit, shortest_possible, longest_possible);
    if (possible && isNearHeader(range, unit, header)) return unit;
  }
  const std::optional<TimeUnit> named = unitInName(field.name);
  if (named && lasts(range, *named, shortest_possible, longest_possible)) return named;
  const TimeUnit usual = isInteger(field.type) ? TimeUnit::ns : TimeUnit::s;
  if (lasts(range, usual, shortest_sweep, longest_possible)) return usual;
  for (const TimeUnit unit : time_units) {
    if (lasts(range, unit, shortest_sweep, longest_sweep)) return unit;
  }
  return std::nullopt;
}

/// Switches less readily than it decides: a clock that drifts across a limit stays what it was.
double limitFor(const std::optional<TimeSource>& prior) {
  if (!prior || prior->origin == TimeOrigin::relative) return same_clock;
  return prior->origin == TimeOrigin::absolute ? 2.0 * same_clock : 0.5 * same_clock;
}

TimeOrigin originOf(const TimeRange& range, TimeUnit unit, Stamp header,
                    const std::optional<TimeSource>& prior) {
  const double to_header = gapTo(header.toSeconds(), range, unit);
  const double to_zero = gapTo(0.0, range, unit);
  const double limit = limitFor(prior);
  if (header.nanoseconds == 0 && to_zero > 1e9) return TimeOrigin::absolute;
  if (to_header < to_zero && to_header <= limit) return TimeOrigin::absolute;
  // A counter that restarts every hour passes zero without counting from the header.
  const bool counter = prior && prior->origin == TimeOrigin::own_clock;
  return to_zero <= limit && !counter ? TimeOrigin::relative : TimeOrigin::own_clock;
}

std::string quoted(const PointField& field) {
  return "field '" + field.name + "'";
}

std::string extent(const TimeRange& range) {
  return toText(range.first) + " to " + toText(range.last);
}

TimeDecision contradiction(const PointField& field, const TimeRange& range,
                           const std::string& parameter, const std::string& why) {
  return {std::nullopt, TimeFault::contradicts_parameter,
          quoted(field) + " contradicts " + parameter + ": " + why + " (" + extent(range) + ")"};
}

TimeDecision withUnit(const PointField& field, const TimeRange& range, TimeUnit unit, Stamp header,
                      const TimeOverrides& overrides, const std::optional<TimeSource>& prior) {
  TimeOrigin origin = originOf(range, unit, header, prior);
  if (overrides.origin == TimeOrigin::absolute) {
    const double gap = gapTo(header.toSeconds(), range, unit);
    if (gap > same_epoch && header.nanoseconds != 0) {
      return contradiction(field, range, "time_origin: absolute",
                           "the header stamp is " + toText(gap) + " s away");
    }
    origin = TimeOrigin::absolute;
  } else if (overrides.origin == TimeOrigin::relative) {
    const bool near_zero = gapTo(0.0, range, unit) <= same_clock;
    if (!near_zero && !overrides.header) {
      return contradiction(field, range, "time_origin: relative",
                           "not near zero; header_stamp can say which point the header is");
    }
    origin = near_zero ? TimeOrigin::relative : TimeOrigin::own_clock;
  }
  // A driver that does not read the sensor's clock stamps a sweep when it is complete.
  const bool relative = origin == TimeOrigin::relative;
  const SweepInstant assumed = relative ? SweepInstant::time_zero : SweepInstant::last;
  return {TimeSource{unit, origin, overrides.header.value_or(assumed)}, TimeFault::none, {}};
}

}  // namespace

const char* remedyOf(TimeFault fault) {
  switch (fault) {
    case TimeFault::none:
    case TimeFault::undecided:
    case TimeFault::switched_off:
      return "";
    case TimeFault::no_field:
      return "set input/time_field to azimuth for a spinning sensor, to the name of the field that "
             "holds the times, or to none if the driver has deskewed the points already";
    case TimeFault::no_values:
    case TimeFault::constant:
      return "let the driver fill the field, or set input/time_field to azimuth for a spinning "
             "sensor, or to none if the driver has deskewed the points already";
    case TimeFault::implausible:
    case TimeFault::contradicts_parameter:
      return "set input/time_field and input/time_unit to what the driver documents, or "
             "input/time_field to azimuth for a spinning sensor, or to none if the driver has "
             "deskewed the points already";
  }
  return "";
}

TimeDecision decideTimeSource(const PointField& field, const TimeRange& range, Stamp header,
                              const TimeOverrides& overrides,
                              const std::optional<TimeSource>& prior) {
  if (range.finite == 0) return {std::nullopt, TimeFault::no_values, quoted(field) + " is all NaN"};
  const bool may_be_chance = prior && range.finite < many_times;
  if (!(range.span() > 0.0) && !may_be_chance) {
    return {std::nullopt, TimeFault::constant, quoted(field) + " is constant"};
  }
  if (overrides.unit) {
    const double shortest = range.finite < many_times ? 0.0 : shortest_possible;
    if (!lasts(range, *overrides.unit, shortest, longest_possible)) {
      const double duration = range.span() * secondsIn(*overrides.unit);
      return contradiction(field, range, std::string("time_unit: ") + toString(*overrides.unit),
                           "a sweep would last " + toText(duration) + " s");
    }
    return withUnit(field, range, *overrides.unit, header, overrides, prior);
  }
  if (prior && lasts(range, prior->unit, 0.0, longest_possible)) {
    return withUnit(field, range, prior->unit, header, overrides, prior);
  }
  const std::optional<TimeUnit> unit = unitOf(field, range, header);
  if (unit) return withUnit(field, range, *unit, header, overrides, std::nullopt);
  return {std::nullopt, TimeFault::implausible,
          quoted(field) + ", " + toString(field.type) + ", from " + extent(range) +
              " is a sweep in no unit"};
}

}  // namespace revisit_slam
