// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_description.h"

#include <cmath>
#include <cstdio>

namespace revisit_slam {
namespace {

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f ms", seconds * 1e3);
  return text;
}

/// Where the reference stamp lies in a sweep of this duration, both in seconds.
std::string position(double after_first, double duration) {
  const double part = duration > 0.0 ? after_first / duration : 0.0;
  if (std::abs(part) < 0.05) return "= first point";
  if (std::abs(part - 1.0) < 0.05) return "= last point";
  if (std::abs(part - 0.5) < 0.05) return "= middle";
  const char* side = after_first < 0.0 ? " before the first point" : " after the first point";
  return milliseconds(std::abs(after_first)) + side;
}

std::string whereIsReference(const TimeSource& source, const TimeRange& range, Stamp stamp) {
  const bool absolute = source.origin == TimeOrigin::absolute;
  if (!absolute && source.header != SweepInstant::time_zero) {
    const char* point = source.header == SweepInstant::middle ? "" : " point";
    return std::string("taken as ") + toString(source.header) + point;
  }
  const double zero_to_stamp = absolute ? stamp.toSeconds() : 0.0;
  const double unit = secondsIn(source.unit);
  return position(zero_to_stamp - range.first * unit, range.span() * unit);
}

}  // namespace

std::string toText(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", number);
  return text;
}

std::string describeTimes(const PointField& field, const TimeSource& source, const TimeRange& range,
                          const ReferenceStamp& reference) {
  return "field '" + field.name + "', " + toString(field.type) + ", " + toString(source.origin) +
         " " + toString(source.unit) + ", sweep " +
         milliseconds(range.span() * secondsIn(source.unit)) + ", " + reference.name + " " +
         whereIsReference(source, range, reference.stamp);
}

}  // namespace revisit_slam
