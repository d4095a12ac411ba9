// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/ring_limit.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

const PointToPoint kPoint{{0, 0, 0}, {0, 0, 0}};
constexpr double kRings = 20.0;

/// A wall across x, a little of all else in every direction, and rings.
NormalEquations equationsWith(double wall, double all_else, double ring_factor) {
  NormalEquations equations;
  equations.add(PointToPlane{{0, 0, 0}, {1, 0, 0}, 0.0}, wall);
  equations.add(kPoint, all_else);
  equations.add(kPoint, ring_factor * kRings);
  equations.countRing(ring_factor * kRings);
  return equations;
}

TEST(RingLimit, RingsWeighNoMoreThanATwentiethOfAllElse) {
  RingLimit limit(false);
  EXPECT_EQ(limit.factor(), 1.0);
  for (int i = 0; i < 3; ++i) {
    limit.update(equationsWith(1000.0, 2.0, limit.factor()));
    EXPECT_TRUE(limit.isNeeded());
    EXPECT_NEAR(limit.factor() * kRings, 0.05 * 2.0, 1e-9);
  }
  limit.update(equationsWith(0.0, 500.0, limit.factor()));
  EXPECT_FALSE(limit.isNeeded());
  limit.update(equationsWith(0.0, 0.0, limit.factor()));
  EXPECT_GT(limit.factor(), 0.0);  // the equations stay regular
}

TEST(RingLimit, WhereNoRingsAreMatchedNothingIsLimitedAnyLonger) {
  RingLimit limit(false);
  limit.update(equationsWith(1000.0, 2.0, 1.0));
  ASSERT_TRUE(limit.isNeeded());
  limit.update(equationsWith(1000.0, 2.0, 0.0));
  EXPECT_FALSE(limit.isNeeded());
  EXPECT_EQ(limit.limited(Matrix6::Identity()), Matrix6::Identity());
}

TEST(RingLimit, ThePredictionWeighsNothingWhereRingsWouldHold) {
  RingLimit limit(false);
  const Matrix6 weight = 7.0 * Matrix6::Identity();
  EXPECT_EQ(limit.limited(weight), weight);
  limit.update(equationsWith(1000.0, 2.0, 1.0));
  Matrix6 expected = weight;
  expected(1, 1) = expected(2, 2) = 0.0;
  EXPECT_TRUE(limit.limited(weight).isApprox(expected, 1e-12));
}

TEST(RingLimit, NothingIsLimitedOnceTheMotionIsSeen) {
  RingLimit limit(true);
  limit.update(equationsWith(1000.0, 2.0, 1.0));
  EXPECT_FALSE(limit.isNeeded());
  EXPECT_EQ(limit.limited(Matrix6::Identity()), Matrix6::Identity());
}

}  // namespace
}  // namespace revisit_slam
