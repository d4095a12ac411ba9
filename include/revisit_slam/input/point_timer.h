// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/input/azimuth_times.h"
#include "revisit_slam/input/kept_points.h"
#include "revisit_slam/input/scan_period.h"
#include "revisit_slam/input/time_decision.h"
#include "revisit_slam/input/time_description.h"

namespace revisit_slam {

/// When a sweep was measured, as Scan holds it.
struct SweepTimes {
  Stamp stamp;
  std::vector<float> times;
};

/// Times the points of the sweeps of one sensor. Where the times come from is decided on the first
/// usable sweep and kept until later sweeps contradict it.
///
/// The stamp is the instant of the last kept point. A sweep whose times cannot be used after others
/// could gets the stamp that its last point would have had, so that stamps go on increasing.
class PointTimer {
 public:
  /// Throws ParameterError on a word that is no choice.
  explicit PointTimer(const ScanInputConfig& config);

  /// Drops points without a time where others have one.
  SweepTimes time(const PointView& view, const ReferenceStamp& reference, KeptPoints& kept);

  /// One line on where the times come from, or why there are none; changes only with that. Empty
  /// before the first scan.
  const std::string& description() const { return description_; }
  /// What a user can do where there are no times; empty where nothing has to be done.
  std::string remedy() const { return remedyOf(fault_); }
  bool deskewing() const { return fault_ == TimeFault::none; }
  /// Whether no sweep so far has had the field that a parameter names.
  bool lacksNamedField() const;

 private:
  SweepTimes timeByField(const PointView& view, const ReferenceStamp& reference, KeptPoints& kept);
  bool isUsual(const TimeRange& range, TimeUnit unit) const;
  SweepTimes timeByAzimuth(const ReferenceStamp& reference, const KeptPoints& kept);
  SweepTimes accept(const PointField& field, const TimeSource& source, const TimeRange& range,
                    const ReferenceStamp& reference);
  SweepTimes withoutTimes(TimeFault fault, const std::string& reason, Stamp header);

  ScanInputConfig config_;
  TimeOverrides overrides_;
  ScanPeriod period_;
  std::optional<TimeSource> source_;
  std::string field_;
  TimeFault fault_ = TimeFault::undecided;
  std::int64_t last_point_after_header_ = 0;
  std::string description_;
};

}  // namespace revisit_slam
