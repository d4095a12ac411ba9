// SPDX-License-Identifier: MIT
#include "revisit_slam/util/recent_times.h"

#include <gtest/gtest.h>

#include "revisit_slam/util/quantile.h"

namespace revisit_slam {
namespace {

TEST(Quantile, IsTheSmallestValueThatTheShareDoesNotExceed) {
  const std::vector<double> values{5.0, 1.0, 4.0, 2.0, 3.0};
  EXPECT_EQ(quantile(values, 0.0), 1.0);
  EXPECT_EQ(quantile(values, 0.2), 1.0);
  EXPECT_EQ(quantile(values, 0.21), 2.0);
  EXPECT_EQ(quantile(values, 0.5), 3.0);
  EXPECT_EQ(quantile(values, 1.0), 5.0);
}

TEST(RecentTimes, SaysSoBeforeTheFirst) {
  EXPECT_EQ(RecentTimes().summary(), "none yet");
}

TEST(RecentTimes, SummarisesMedianPercentileAndLargest) {
  RecentTimes times;
  for (int i = 200; i >= 1; --i) times.add(i);
  EXPECT_EQ(times.summary(), "100.0, 198.0, 200.0 of 200");
}

TEST(RecentTimes, ForgetsTheOldest) {
  RecentTimes times;
  times.add(1e6);
  for (std::size_t i = 0; i < RecentTimes::kRemembered; ++i) times.add(2.0);
  EXPECT_EQ(times.summary(), "2.0, 2.0, 2.0 of 1000");
}

}  // namespace
}  // namespace revisit_slam
