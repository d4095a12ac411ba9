// SPDX-License-Identifier: MIT
#include "revisit_slam/types/travelled_distance.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(TravelledDistance, AnHourOfJitterIsNoWay) {
  RandomNumbers random(3);
  TravelledDistance distance;
  for (int i = 0; i < 36'000; ++i)
    distance.go({random.gaussian(0.012), random.gaussian(0.012), random.gaussian(0.012)});
  EXPECT_EQ(distance.metres(), 0.0);
}

TEST(TravelledDistance, SlowMotionCountsWhole) {
  TravelledDistance distance;
  for (int i = 0; i <= 1000; ++i) distance.go({0.01 * i, 0, 0});  // 10 cm/s at 10 Hz
  EXPECT_NEAR(distance.metres(), 10.0, 0.2);
  EXPECT_NEAR(distance.metresTo({10.0, 0, 0}), 10.0, 1e-9);
}

TEST(TravelledDistance, StepsAreSummedExactly) {
  TravelledDistance distance;
  distance.start({5, 0, 0});
  for (int i = 1; i <= 10; ++i) distance.go({5, 1.25 * i, 0});
  EXPECT_EQ(distance.metres(), 12.5);
}

}  // namespace
}  // namespace revisit_slam
