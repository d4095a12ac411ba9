// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/input/point_timer.h"
#include "revisit_slam/input/scan_reading.h"

namespace revisit_slam {

/// Makes scans of the messages of one sensor, by what they contain and not by who sent them.
class PointReader {
 public:
  /// Throws ParameterError on a word that is no choice.
  explicit PointReader(const ScanInputConfig& config) : timer_(config) {}

  ScanReading read(const PointView& view, const ReferenceStamp& reference);

  const std::string& description() const { return timer_.description(); }
  std::string remedy() const { return timer_.remedy(); }
  bool deskewing() const { return timer_.deskewing(); }

 private:
  PointTimer timer_;
};

}  // namespace revisit_slam
