// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "revisit_slam/odometry/odometry.h"
#include "support/ringed_field.h"

namespace revisit_slam {
namespace {

/// Metres that the odometry says it came, of 20 m straight ahead, after speeding up.
double wayOverTheField(const OdometryConfig& config) {
  const RingedField field;
  RandomNumbers random(12);
  Odometry odometry(config);
  Pose T_field_base;
  OdometryResult result;
  double speed = 0.0;  // m per scan
  for (std::int64_t i = 0; T_field_base.translation.x() < 20.0; ++i) {
    result = odometry.registerScan(field.scan({i * 100'000'000}, T_field_base, 0.01, random));
    speed = std::min(0.6, speed + 0.05);
    T_field_base.translation.x() += speed;
  }
  return result.scan->T_odom_base.translation.x() + speed;
}

TEST(OdometryOnRings, PlanesFreeItFromTheRingsThatMoveAlong) {
  OdometryConfig config;
  config.registration.final_sigma = 1000.0;  // one tolerance
  EXPECT_NEAR(wayOverTheField(config), 20.0, 0.8);
  config.registration.planes = false;
  EXPECT_LT(wayOverTheField(config), 15.0);
}

/// A fine tolerance does not hold the estimate back, not even from rest.
TEST(OdometryOnRings, AFineEndDoesNotSlip) {
  EXPECT_NEAR(wayOverTheField({}), 20.0, 0.2);
}

}  // namespace
}  // namespace revisit_slam
