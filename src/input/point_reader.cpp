// SPDX-License-Identifier: MIT
#include "revisit_slam/input/point_reader.h"

#include <cstdint>
#include <utility>

namespace revisit_slam {
namespace {

/// The rejection and its detail, or none.
ScanReading check(const PointView& view) {
  ScanReading reading;
  const auto reject = [&reading](ScanRejection rejection, const std::string& detail) {
    reading.rejection = rejection;
    reading.detail = detail;
    return reading;
  };
  if (view.width == 0 || view.height == 0) {
    return reject(ScanRejection::empty,
                  std::to_string(view.width) + " x " + std::to_string(view.height) + " points");
  }
  for (const char* name : {"x", "y", "z"}) {
    const PointField* field = view.find(name);
    if (!field) return reject(ScanRejection::missing_xyz, "fields: " + view.fieldNames());
    if (field->type == NumberType::unknown) {
      return reject(ScanRejection::missing_xyz, std::string("unknown datatype of field ") + name);
    }
  }
  if (const std::string fault = layoutFault(view); !fault.empty()) {
    return reject(ScanRejection::bad_layout, fault);
  }
  return reading;
}

/// What stamps of ROS can be: since 1970, with a room for seconds of 32 bits. Differences of such
/// stamps overflow nowhere.
bool isInRange(Stamp stamp) {
  constexpr std::int64_t end = (std::int64_t{1} << 32) * 1'000'000'000;
  return 0 <= stamp.nanoseconds && stamp.nanoseconds < end;
}

ScanReading outOfRange(Stamp stamp) {
  ScanReading reading;
  reading.rejection = ScanRejection::bad_stamp;
  reading.detail = std::to_string(stamp.nanoseconds) +
                   " ns are no time since 1970 with 32 bits of " +
                   "seconds; are point times or the timebase wrong?";
  return reading;
}

/// A name that was mistyped must not quietly cost the deskewing.
ScanReading withoutNamedField(const std::string& description) {
  ScanReading reading;
  reading.rejection = ScanRejection::no_time_field;
  reading.detail = description + "; set input/time_field to one of these fields, or to auto";
  return reading;
}

}  // namespace

ScanReading PointReader::read(const PointView& view, const ReferenceStamp& reference) {
  ScanReading reading = check(view);
  if (reading.rejection != ScanRejection::none) return reading;
  KeptPoints kept = readPoints(view);
  reading.counts = kept.counts;
  if (kept.points.empty()) {
    reading.rejection = ScanRejection::no_finite_points;
    reading.detail = std::to_string(kept.counts.not_finite) + " not finite, " +
                     std::to_string(kept.counts.at_origin) + " at the origin";
    return reading;
  }
  if (!isInRange(reference.stamp)) return outOfRange(reference.stamp);
  SweepTimes sweep = timer_.time(view, reference, kept);
  if (timer_.lacksNamedField()) return withoutNamedField(timer_.description());
  if (!isInRange(sweep.stamp)) return outOfRange(sweep.stamp);
  reading.counts = kept.counts;
  reading.scan.emplace();
  reading.scan->stamp = sweep.stamp;
  reading.scan->points = std::move(kept.points);
  reading.scan->times = std::move(sweep.times);
  reading.scan->intensities = readIntensities(view, kept.byte_offsets);
  return reading;
}

}  // namespace revisit_slam
