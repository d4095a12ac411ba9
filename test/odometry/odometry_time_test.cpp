// SPDX-License-Identifier: MIT
// What the time between two scans does to the prediction and to the tolerance.
#include <gtest/gtest.h>

#include "revisit_slam/odometry/odometry.h"
#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

/// Too few points to be registered: its pose is the prediction.
Scan unregisteredScan(std::int64_t nanoseconds) {
  return {{nanoseconds}, Points(5, {1, 1, 1}), {}, {}, {}};
}

TEST(Odometry, PredictsForTheTimeThatPassedUpToTheLongestPrediction) {
  const Drive drive = driveInRoom(12);
  for (const double seconds : {0.1, 0.2, 0.05, 0.7, 1.0, 5.0, 3600.0}) {
    Odometry odometry(roomConfig());
    OdometryResult last;
    for (const Scan& scan : drive.scans) last = odometry.registerScan(scan);
    const auto next =
        odometry.registerScan(unregisteredScan(last.scan->stamp.plusSeconds(seconds).nanoseconds));
    ASSERT_EQ(next.scan->registration.outcome, RegistrationOutcome::too_few_correspondences);
    const Pose moved = last.scan->T_odom_base.inverse() * next.scan->T_odom_base;
    const Tangent expected = std::min(seconds, 1.0) * last.scan->velocity_base;
    EXPECT_LT((log(moved) - expected).norm(), 1e-9) << seconds;
    EXPECT_LT((seconds * next.scan->velocity_base - expected).norm(), 1e-9) << seconds;
  }
}

TEST(Odometry, AfterALongGapTheToleranceStartsAnewForOneScan) {
  OdometryConfig config = roomConfig();
  config.threshold.min_motion = 1e-3;  // every prediction counts
  const Drive drive = driveInRoom(30);
  Odometry odometry(config);
  double sigma = 0.0;
  for (int i = 0; i < 20; ++i) sigma = odometry.registerScan(drive.scans[i]).scan->sigma;
  EXPECT_LT(sigma, 0.9 * config.threshold.initial);
  std::vector<double> sigmas;
  for (int i = 20; i < 23; ++i) {
    Scan late = drive.scans[i];
    late.stamp = late.stamp.plusSeconds(1.0);  // 1.1 s after the one before
    sigmas.push_back(odometry.registerScan(late).scan->sigma);
  }
  EXPECT_EQ(sigmas[0], config.threshold.initial);
  EXPECT_LT(sigmas[1], sigma);  // the gap's own error was not counted
}

}  // namespace
}  // namespace revisit_slam
