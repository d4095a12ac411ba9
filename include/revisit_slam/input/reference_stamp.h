// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "revisit_slam/input/time_unit.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// An instant that a message carries for its whole sweep.
struct ReferenceStamp {
  Stamp stamp;
  const char* name = "header";
  /// Where the message type defines that its times count from this instant, and in which unit.
  std::optional<TimeUnit> defined_unit;
};

}  // namespace revisit_slam
