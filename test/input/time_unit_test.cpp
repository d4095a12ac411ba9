// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_unit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace revisit_slam {
namespace {

TEST(TimeUnit, namesReadBack) {
  for (const TimeUnit unit : time_units) EXPECT_EQ(timeUnitFromString(toString(unit)), unit);
  EXPECT_FALSE(timeUnitFromString("minutes"));
}

TEST(TimeUnit, wholeNanosecondsAreExact) {
  EXPECT_EQ(toNanoseconds(99'840'000, TimeUnit::ns), 99'840'000);
  EXPECT_EQ(toNanoseconds(-0.1, TimeUnit::s), -100'000'000);
  EXPECT_EQ(toNanoseconds(1'700'000'000'123'456, TimeUnit::us), 1'700'000'000'123'456'000);
}

TEST(TimeUnit, secondsSince1970LoseNoMoreThanTheDoubleDoes) {
  const double seconds = 1'700'000'000.25 + 1.0 / 1024;
  EXPECT_EQ(toNanoseconds(seconds, TimeUnit::s), 1'700'000'000'250'976'563);
}

TEST(TimeUnit, numbersOutOfRangeAreClamped) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const TimeUnit unit : time_units) {
    EXPECT_GT(toNanoseconds(1e300, unit), 4'000'000'000'000'000'000);
    EXPECT_LT(toNanoseconds(-infinity, unit), -4'000'000'000'000'000'000);
  }
}

}  // namespace
}  // namespace revisit_slam
