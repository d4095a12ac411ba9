// SPDX-License-Identifier: MIT
#include "revisit_slam/input/point_timer.h"

#include <algorithm>

#include "revisit_slam/input/time_fields.h"

namespace revisit_slam {
namespace {

std::vector<float> secondsFromLast(const std::vector<double>& times, double last, TimeUnit unit) {
  std::vector<float> seconds(times.size());
  const double factor = secondsIn(unit);
  for (std::size_t i = 0; i < times.size(); ++i) {
    seconds[i] = static_cast<float>((times[i] - last) * factor);
  }
  return seconds;
}

void dropPointsBeyond(const TimeRange& range, KeptPoints& kept, std::vector<double>& times) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    kept.points[count] = kept.points[i];
    times[count] = times[i];
    count += range.contains(times[i]);
  }
  kept.counts.no_time += times.size() - count;
  kept.counts.kept = count;
  kept.points.resize(count);
  times.resize(count);
}

double fractionAtHeader(SweepInstant header) {
  if (header == SweepInstant::first) return 0.0;
  return header == SweepInstant::middle ? 0.5 : 1.0;
}

}  // namespace

PointTimer::PointTimer(const ScanInputConfig& config)
    : config_(config), overrides_(TimeOverrides::from(config)) {}

SweepTimes PointTimer::time(const PointView& view, const ReferenceStamp& reference,
                            KeptPoints& kept) {
  if (config_.time_field == "none") {
    return withoutTimes(TimeFault::switched_off, "parameter time_field is none", reference.stamp);
  }
  if (config_.time_field == "azimuth") return timeByAzimuth(reference, kept);
  return timeByField(view, reference, kept);
}

SweepTimes PointTimer::timeByField(const PointView& view, const ReferenceStamp& reference,
                                   KeptPoints& kept) {
  TimeOverrides overrides = overrides_;
  if (reference.defined_unit) {
    overrides.unit = overrides.unit.value_or(*reference.defined_unit);
    overrides.origin = TimeOrigin::relative;
  }
  period_.add(reference.stamp);
  TimeDecision first_fault;
  for (const PointField& field : findTimeFields(view, config_.time_field)) {
    std::vector<double> times = readField(view, field, kept.byte_offsets);
    const TimeRange all = TimeRange::of(times);
    const auto prior = field.name == field_ ? source_ : std::nullopt;
    TimeRange range = prior && isUsual(all, prior->unit) ? all : TimeRange::ofBulk(times);
    TimeDecision decision = decideTimeSource(field, range, reference.stamp, overrides, prior);
    if (decision.source) {
      if (isUsual(all, decision.source->unit)) range = all;
      if (range.finite < times.size()) dropPointsBeyond(range, kept, times);
      SweepTimes sweep = accept(field, *decision.source, range, reference);
      sweep.times = secondsFromLast(times, range.last, decision.source->unit);
      return sweep;
    }
    if (first_fault.fault == TimeFault::none) first_fault = std::move(decision);
  }
  if (first_fault.fault != TimeFault::none) {
    return withoutTimes(first_fault.fault, first_fault.reason, reference.stamp);
  }
  const std::string wanted =
      config_.time_field == "auto" ? "no time field" : "no field '" + config_.time_field + "'";
  return withoutTimes(TimeFault::no_field, wanted + " (fields: " + view.fieldNames() + ")",
                      reference.stamp);
}

/// Whether no time needs to be doubted: a sweep lasts no longer than it takes to the next.
bool PointTimer::isUsual(const TimeRange& range, TimeUnit unit) const {
  constexpr double tolerance = 1.1;
  return range.span() * secondsIn(unit) <= tolerance * period_.seconds();
}

SweepTimes PointTimer::accept(const PointField& field, const TimeSource& source,
                              const TimeRange& range, const ReferenceStamp& reference) {
  const bool known = deskewing() && source_ && *source_ == source && field_ == field.name;
  if (!known) description_ = "points: " + describeTimes(field, source, range, reference);
  fault_ = TimeFault::none;
  source_ = source;
  field_ = field.name;
  const Stamp stamp = stampOfLastPoint(source, range, reference.stamp);
  last_point_after_header_ = stamp.nanoseconds - reference.stamp.nanoseconds;
  return {stamp, {}};
}

SweepTimes PointTimer::withoutTimes(TimeFault fault, const std::string& reason, Stamp header) {
  if (fault != fault_) description_ = "deskewing off: " + reason;
  fault_ = fault;
  return {{header.nanoseconds + last_point_after_header_}, {}};
}

bool PointTimer::lacksNamedField() const {
  return fault_ == TimeFault::no_field && config_.time_field != "auto" && !source_;
}

SweepTimes PointTimer::timeByAzimuth(const ReferenceStamp& reference, const KeptPoints& kept) {
  period_.add(reference.stamp);
  const double period = config_.scan_period > 0.0 ? config_.scan_period : period_.seconds();
  std::vector<float> times =
      sweepFractions(kept.points, {config_.azimuth_clockwise, config_.azimuth_start});
  const float last = *std::max_element(times.begin(), times.end());
  for (float& time : times) time = (time - last) * static_cast<float>(period);
  const SweepInstant header = overrides_.header.value_or(SweepInstant::last);
  if (!deskewing()) {
    description_ = std::string("points: azimuth, ") +
                   (config_.azimuth_clockwise ? "clockwise" : "counter-clockwise") + " from " +
                   toText(config_.azimuth_start) + " deg, sweep " +
                   (config_.scan_period > 0.0 ? toText(period * 1e3) + " ms"
                                              : std::string("from the header stamps")) +
                   ", " + reference.name + " = " + toString(header) +
                   (header == SweepInstant::middle ? "" : " point");
  }
  fault_ = TimeFault::none;
  return {reference.stamp.plusSeconds((last - fractionAtHeader(header)) * period),
          std::move(times)};
}

}  // namespace revisit_slam
