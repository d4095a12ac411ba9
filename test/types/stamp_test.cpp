// SPDX-License-Identifier: MIT
#include "revisit_slam/types/stamp.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

constexpr std::int64_t kToday = 1'700'000'000'123'456'789;

TEST(Stamp, AddsSecondsToTheNanosecond) {
  for (const std::int64_t step :
       {0LL, 1LL, -1LL, 99'999'999LL, -100'000'001LL, 3'600'000'000'007LL})
    EXPECT_EQ(Stamp{kToday}.plusSeconds(static_cast<double>(step) * 1e-9), Stamp{kToday + step});
}

TEST(Stamp, DifferencesKeepNanosecondsOfLargeStamps) {
  EXPECT_EQ(secondsBetween({kToday}, {kToday + 1}), 1e-9);
  EXPECT_EQ(secondsBetween({kToday + 100'000'000}, {kToday}), -0.1);
}

TEST(Stamp, SecondsAreRoundedNotCut) {
  EXPECT_EQ(Stamp::fromSeconds(0.1 + 0.2), Stamp{300'000'000});
  EXPECT_EQ(Stamp::fromSeconds(-1.5), Stamp{-1'500'000'000});
  EXPECT_EQ(Stamp::fromSeconds(0.9999999999), Stamp{1'000'000'000});
  EXPECT_EQ(Stamp::fromSeconds(-0.9999999999), Stamp{-1'000'000'000});
}

TEST(Stamp, SecondsOfTodayAreAsExactAsADouble) {
  EXPECT_NEAR(Stamp::fromSeconds(Stamp{kToday}.toSeconds()).nanoseconds - kToday, 0, 240);
}

TEST(Stamp, OrdersInTime) {
  const Stamp early{kToday}, late{kToday + 1};
  EXPECT_TRUE(early < late && early <= late && late > early && late >= early && early != late);
  EXPECT_FALSE(late < early || late <= early || early > late || early >= late || early == late);
  EXPECT_TRUE(early <= early && early >= early && early == early);
  EXPECT_FALSE(early < early || early > early || early != early);
}

}  // namespace
}  // namespace revisit_slam
