// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_unit.h"

#include <cmath>
#include <limits>

namespace revisit_slam {

const char* toString(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::s:
      return "s";
    case TimeUnit::ms:
      return "ms";
    case TimeUnit::us:
      return "us";
    case TimeUnit::ns:
      return "ns";
  }
  return "";
}

std::optional<TimeUnit> timeUnitFromString(const std::string& text) {
  for (const TimeUnit unit : time_units) {
    if (text == toString(unit)) return unit;
  }
  return std::nullopt;
}

std::int64_t nanosecondsIn(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::s:
      return 1'000'000'000;
    case TimeUnit::ms:
      return 1'000'000;
    case TimeUnit::us:
      return 1'000;
    case TimeUnit::ns:
      return 1;
  }
  return 1;
}

double secondsIn(TimeUnit unit) {
  return static_cast<double>(nanosecondsIn(unit)) * 1e-9;
}

std::int64_t toNanoseconds(double value, TimeUnit unit) {
  const std::int64_t factor = nanosecondsIn(unit);
  // Half of the range, so that the fraction cannot overflow it either.
  const double limit = static_cast<double>(std::numeric_limits<std::int64_t>::max() / factor) * 0.5;
  const double clamped = std::fmin(std::fmax(value, -limit), limit);
  const double whole = std::floor(clamped);
  return static_cast<std::int64_t>(whole) * factor +
         std::llround((clamped - whole) * static_cast<double>(factor));
}

}  // namespace revisit_slam
