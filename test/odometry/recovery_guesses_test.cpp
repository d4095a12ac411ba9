// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/recovery_guesses.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace revisit_slam {
namespace {

PredictedMotion ahead(double speed, double seconds) {
  Tangent velocity = Tangent::Zero();
  velocity[0] = speed;
  PredictedMotion predicted;
  predicted.velocity = ConstantMotion(velocity);
  predicted.seconds = predicted.seconds_untold = seconds;
  return predicted;
}

bool hasOneNear(const std::vector<Pose>& guesses, double x, double turn) {
  return std::any_of(guesses.begin(), guesses.end(), [&](const Pose& guess) {
    const Pose wanted{expSO3({0.0, 0.0, turn}), {x, 0.0, 0.0}};
    const Pose error = wanted.inverse() * guess;
    return error.translation.norm() < 5.0 && error.angle() < 0.14;
  });
}

TEST(RecoveryGuesses, reachAllThatABaseDoesInAGap) {
  const std::vector<Pose> guesses = recoveryGuesses(ahead(10.0, 2.0));
  for (const double x : {0.0, 8.0, 20.0, 32.0})  // stopped, braked, went on, sped up
    for (const double turn : {-0.8, 0.0, 0.4}) EXPECT_TRUE(hasOneNear(guesses, x, turn)) << x;
}

/// Behind it the scans were moved on for a second of them.
TEST(RecoveryGuesses, reachAllThatABaseDoesWhileItsSensorIsCovered) {
  PredictedMotion predicted = ahead(10.0, 0.1);
  predicted.seconds_untold = 3.0;
  predicted.extrapolated = 1.0;
  const std::vector<Pose> guesses = recoveryGuesses(predicted);
  for (const double x : {-10.0, 5.0, 20.0, 35.0}) EXPECT_TRUE(hasOneNear(guesses, x, 0.0)) << x;
}

TEST(RecoveryGuesses, areTurnedAloneWhereTheWayIsShort) {
  const std::vector<Pose> guesses = recoveryGuesses(ahead(10.0, 0.1));
  EXPECT_EQ(guesses.size(), 7u);
  for (const Pose& guess : guesses) EXPECT_NEAR(guess.translation.norm(), 1.0, 1e-9);
  EXPECT_TRUE(hasOneNear(guesses, 1.0, 0.8));
}

/// Within reach: days later no motion was steady.
TEST(RecoveryGuesses, areNoFartherThanAnythingWentAfterADay) {
  const std::vector<Pose> guesses = recoveryGuesses(ahead(10.0, 86'400.0));
  EXPECT_TRUE(hasOneNear(guesses, 0.0, 0.0));
  for (const Pose& guess : guesses) EXPECT_LE(guess.translation.norm(), 1000.0);
}

}  // namespace
}  // namespace revisit_slam
