// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_source.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

const Stamp header{1'700'000'000'000'000'000};

std::int64_t lastAfterHeader(TimeOrigin origin, SweepInstant instant, double first, double last) {
  const TimeSource source{TimeUnit::ms, origin, instant};
  return stampOfLastPoint(source, {first, last, 2}, header).nanoseconds - header.nanoseconds;
}

TEST(TimeSource, theHeaderIsTimeZeroOrTheInstantOfTheParameter) {
  const auto relative = TimeOrigin::relative;
  EXPECT_EQ(lastAfterHeader(relative, SweepInstant::time_zero, 0, 100), 100'000'000);
  EXPECT_EQ(lastAfterHeader(relative, SweepInstant::time_zero, -99, 0.5), 500'000);
  EXPECT_EQ(lastAfterHeader(relative, SweepInstant::first, 20, 100), 100'000'000);
  EXPECT_EQ(lastAfterHeader(relative, SweepInstant::middle, 0, 100), 50'000'000);
  EXPECT_EQ(lastAfterHeader(relative, SweepInstant::last, 0, 100), 0);
  EXPECT_EQ(lastAfterHeader(relative, SweepInstant::last, -100, -20), -20'000'000);
}

TEST(TimeSource, anotherClockGivesDifferencesOnly) {
  EXPECT_EQ(lastAfterHeader(TimeOrigin::own_clock, SweepInstant::last, 5000, 5100), 0);
  EXPECT_EQ(lastAfterHeader(TimeOrigin::own_clock, SweepInstant::first, 5000, 5100), 100'000'000);
}

TEST(TimeSource, absoluteTimesDoNotUseTheHeader) {
  const TimeSource source{TimeUnit::ns, TimeOrigin::absolute, SweepInstant::first};
  EXPECT_EQ(stampOfLastPoint(source, {7e8, 8e8, 2}, header).nanoseconds, 800'000'000);
}

TEST(TimeSource, wordsOfTheParametersAreChecked) {
  ScanInputConfig config;
  config.header_stamp = "middle";
  EXPECT_EQ(TimeOverrides::from(config).header, SweepInstant::middle);
  EXPECT_FALSE(TimeOverrides::from(config).unit);
  config.time_unit = "minutes";
  try {
    TimeOverrides::from(config);
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_STREQ(error.what(), "time_unit is 'minutes'; allowed: auto, s, ms, us, ns");
  }
}

}  // namespace
}  // namespace revisit_slam
