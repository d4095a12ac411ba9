// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/input/point_view.h"
#include "revisit_slam/input/time_unit.h"

namespace revisit_slam {

/// The fields that may hold the time of a point, the likeliest name first; capital letters do not
/// matter. With a `wanted` other than "auto" only the field of that name.
std::vector<PointField> findTimeFields(const PointView& view, const std::string& wanted);

/// What the name says about the unit: `time_offset_ns`, `stamp_us`, ...
std::optional<TimeUnit> unitInName(const std::string& name);

}  // namespace revisit_slam
