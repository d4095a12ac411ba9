// SPDX-License-Identifier: MIT
#include "revisit_slam/input/scan_period.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(ScanPeriod, dropsAndJumpsDoNotChangeIt) {
  ScanPeriod period;
  EXPECT_EQ(period.seconds(), 0.1);
  for (const double seconds : {1.0, 1.05, 1.1, 1.2, 1.25, 1.3, 90.0, 90.05, 3.0, 3.05}) {
    period.add(Stamp::fromSeconds(seconds));
  }
  EXPECT_NEAR(period.seconds(), 0.05, 1e-9);
}

TEST(ScanPeriod, followsASensorThatChangesItsRate) {
  ScanPeriod period;
  for (int i = 0; i < 20; ++i) period.add(Stamp::fromSeconds(0.1 * i));
  for (int i = 1; i < 10; ++i) period.add(Stamp::fromSeconds(1.9 + 0.05 * i));
  EXPECT_NEAR(period.seconds(), 0.05, 1e-9);
}

}  // namespace
}  // namespace revisit_slam
