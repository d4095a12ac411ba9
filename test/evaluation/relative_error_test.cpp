// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/relative_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/evaluation_fixtures.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(RelativeError, StartsAtEveryTenthPoseAndEndsBeyondTheLength) {
  const RelativeError error = relativeError(matchOf(straightDrive(250), straightDrive(250)));
  // 100 m from starts 0 … 140, 200 m from 0 … 40: the pose after the last metre must exist
  ASSERT_EQ(error.subsequences.size(), 15u + 5u);
  EXPECT_EQ(error.subsequences[2].first, 10u);
  EXPECT_EQ(error.subsequences.back().first, 140u);
  EXPECT_EQ(error.subsequences.back().length, 100.0);
  EXPECT_LT(error.translation_percent, 1e-9);
}

TEST(RelativeError, OfAScaleIsItsPercentageOfTheDrivenWay) {
  const Trajectory reference = straightDrive(150);
  Trajectory estimate = reference;
  for (StampedPose& pose : estimate) pose.T_world_base.translation *= 1.02;
  // a subsequence of 100 m is 101 m long here: the first pose *beyond* the length ends it
  EXPECT_NEAR(relativeError(matchOf(estimate, reference)).translation_percent, 2.02, 1e-9);
}

TEST(RelativeError, OfASteadyTurnIsItsAngle) {
  const Trajectory reference = straightDrive(150);
  Trajectory estimate = reference;
  for (std::size_t i = 0; i < estimate.size(); ++i)
    estimate[i].T_world_base.rotation = expSO3({0.0, 0.001 * static_cast<double>(i), 0.0});
  EXPECT_NEAR(relativeError(matchOf(estimate, reference)).rotation_deg_per_m,
              180.0 / M_PI * 0.101 / 100.0, 1e-12);
}

TEST(RelativeError, DoesNotDependOnTheFrameOfTheEstimate) {
  RandomNumbers random(1);
  const Trajectory reference = windingDrive(400);
  Trajectory estimate = reference;
  for (StampedPose& pose : estimate)
    pose.T_world_base = boxplus(pose.T_world_base, random.tangent(0.1, 0.01));
  const RelativeError error = relativeError(matchOf(estimate, reference));
  const RelativeError other =
      relativeError(matchOf(moved(random.pose(100.0), estimate), reference));
  EXPECT_GT(error.translation_percent, 0.01);
  EXPECT_NEAR(error.translation_percent, other.translation_percent, 1e-9);
  EXPECT_NEAR(error.rotation_deg_per_m, other.rotation_deg_per_m, 1e-9);
}

TEST(RelativeError, IsUnknownForADriveOfLessThanAHundredMetres) {
  const RelativeError error = relativeError(matchOf(straightDrive(100), straightDrive(100)));
  EXPECT_TRUE(error.subsequences.empty());
  EXPECT_TRUE(std::isnan(error.translation_percent));
}

}  // namespace
}  // namespace revisit_slam
