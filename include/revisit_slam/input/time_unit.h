// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace revisit_slam {

enum class TimeUnit { s, ms, us, ns };

constexpr std::array<TimeUnit, 4> time_units{TimeUnit::s, TimeUnit::ms, TimeUnit::us, TimeUnit::ns};

const char* toString(TimeUnit unit);
std::optional<TimeUnit> timeUnitFromString(const std::string& text);

std::int64_t nanosecondsIn(TimeUnit unit);
double secondsIn(TimeUnit unit);

/// The whole nanoseconds of `value`; exact for integers, and for doubles to their own resolution:
/// the product in double would lose 256 ns for a time since 1970. Clamped where out of range.
std::int64_t toNanoseconds(double value, TimeUnit unit);

}  // namespace revisit_slam
