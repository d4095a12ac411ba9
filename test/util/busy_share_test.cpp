// SPDX-License-Identifier: MIT
#include "revisit_slam/util/busy_share.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(BusyShare, isThatOfTheTimeSinceTheLastLook) {
  BusyShare share;
  const BusyShare::Clock::time_point start;
  const auto at = [start](int seconds) { return start + std::chrono::seconds(seconds); };
  EXPECT_EQ(share.look(7.0, at(10)), 0.0);
  EXPECT_DOUBLE_EQ(share.look(8.0, at(14)), 0.25);
  EXPECT_DOUBLE_EQ(share.look(8.0, at(15)), 0.0);
  EXPECT_DOUBLE_EQ(share.look(10.0, at(16)), 2.0);  // of two threads
  EXPECT_EQ(share.look(11.0, at(16)), 0.0);
}

}  // namespace
}  // namespace revisit_slam
