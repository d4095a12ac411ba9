// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/odometry_drift.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

/// In the proportion of the information: what is known best may err by the drift beyond it.
TEST(OdometryDrift, AddsToTheErrorsInTheirProportion) {
  const BackEndConfig config;
  Matrix6 information = Matrix6::Identity();
  information.diagonal() << 100.0, 400.0, 1e4, 1e6, 1e6, 1e6;
  const double drift = 3.0 * config.drift, turn_drift = 3.0 * config.turn_drift;
  const Matrix6 loose = withDrift(information, 3.0, config);
  EXPECT_NEAR(1.0 / loose(2, 2), 1e-4 + drift * drift, 1e-9);
  EXPECT_NEAR(1.0 / loose(0, 0), 100.0 * (1e-4 + drift * drift), 1e-6);
  EXPECT_NEAR(1.0 / loose(4, 4), 1e-6 + turn_drift * turn_drift, 1e-9);
}

TEST(OdometryDrift, LeavesUnknownWhatIsNotKnown) {
  Matrix6 information = Matrix6::Identity();
  information(0, 0) = 0.0;
  EXPECT_EQ(withDrift(information, 3.0, {})(0, 0), 0.0);
}

}  // namespace
}  // namespace revisit_slam
