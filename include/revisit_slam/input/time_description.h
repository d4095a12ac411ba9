// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/input/point_view.h"
#include "revisit_slam/input/reference_stamp.h"
#include "revisit_slam/input/time_source.h"

namespace revisit_slam {

/// "field 't', uint32, relative ns, sweep 99.8 ms, header = first point"
std::string describeTimes(const PointField& field, const TimeSource& source, const TimeRange& range,
                          const ReferenceStamp& reference);

/// A short number for messages: six significant digits.
std::string toText(double number);

}  // namespace revisit_slam
