// SPDX-License-Identifier: MIT
#include "revisit_slam/input/time_range.h"

#include <gtest/gtest.h>

#include <limits>

namespace revisit_slam {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> evenTimes(std::size_t count, double first, double last) {
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i)
    times[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
  return times;
}

void expectRange(const TimeRange& range, double first, double last, std::size_t finite) {
  EXPECT_DOUBLE_EQ(range.first, first);
  EXPECT_DOUBLE_EQ(range.last, last);
  EXPECT_EQ(range.finite, finite);
}

TEST(TimeRange, isThatOfAllFiniteTimes) {
  expectRange(TimeRange::of({0.3, nan, -0.1, 0.2}), -0.1, 0.3, 3);
}

TEST(TimeRange, theBulkOfEvenTimesIsAllOfThem) {
  for (const std::size_t count : {30u, 999u, 60001u})
    expectRange(TimeRange::ofBulk(evenTimes(count, 5.0, 5.1)), 5.0, 5.1, count);
}

TEST(TimeRange, theBulkIsWithoutTimesFarFromIt) {
  for (const double garbage : {0.0, 4294967295.0, 7.0, -1e300, nan}) {
    for (const std::size_t every : {20u, 5000u}) {
      std::vector<double> times = evenTimes(20000, 5.0, 5.1);
      for (std::size_t i = 7; i < times.size(); i += every) times[i] = garbage;
      expectRange(TimeRange::ofBulk(times), 5.0, 5.1, 20000 - 20000 / every);
    }
  }
}

TEST(TimeRange, theBulkOfUnevenTimesIsAllOfThem) {  // a wall takes up most of the sweep
  std::vector<double> times = evenTimes(600, 0.01, 0.095);
  for (const double time : evenTimes(400, 0.0, 0.1)) times.push_back(time);
  expectRange(TimeRange::ofBulk(times), 0.0, 0.1, 1000);
}

TEST(TimeRange, aFewTimesHaveNoBulk) {
  expectRange(TimeRange::ofBulk({0.0, 0.0, 0.0, 9.0}), 0.0, 9.0, 4);
}

}  // namespace
}  // namespace revisit_slam
