// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Why a message gave no scan.
enum class ScanRejection {
  none,
  empty,
  no_finite_points,
  missing_xyz,
  bad_layout,
  bad_stamp,
  no_stamp,
  no_time_field,
  unsupported_type,
  internal_error,
};

/// In words, for a log line and for counting by reason.
const char* describe(ScanRejection rejection);

/// received = not_finite + at_origin + no_time + kept.
struct PointCounts {
  std::size_t received = 0;
  /// A coordinate is NaN or infinite.
  std::size_t not_finite = 0;
  /// (0, 0, 0): how many drivers write "no return".
  std::size_t at_origin = 0;
  /// The time is NaN, infinite or far from all others, where other points of the scan have one.
  std::size_t no_time = 0;
  std::size_t kept = 0;
};

/// What became of one message.
struct ScanReading {
  std::optional<Scan> scan;
  ScanRejection rejection = ScanRejection::none;
  /// The numbers or names behind the rejection.
  std::string detail;
  PointCounts counts;
  /// From the message's header, known for a rejected message too where the header is readable.
  std::string frame_id;
  Stamp header_stamp;
  std::size_t sensor = 0;  ///< number of its topic among input/topics
};

}  // namespace revisit_slam
