// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/odometry_stage.h"

#include <gtest/gtest.h>

#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

SlamConfig roomSlam() {
  SlamConfig config;
  config.odometry = roomConfig();
  return config;
}

ScanReading readingOf(const Scan& scan) {
  ScanReading reading;
  reading.scan = scan;
  reading.frame_id = "lidar";
  reading.counts.received = scan.points.size();
  return reading;
}

TEST(OdometryStage, handsOnScansWithTheirRegistrationProblem) {
  const Drive drive = driveInRoom(3);
  OdometryStage stage(roomSlam(), SessionId{5});
  for (std::uint32_t i = 0; i < 3; ++i) {
    const OdometryStage::Result result = stage.process(readingOf(drive.scans[i]));
    ASSERT_TRUE(result.output.scan);
    EXPECT_EQ(result.output.scan->id, (ScanId{i, SessionId{5}}));
    EXPECT_EQ(result.output.scan->sensor_frame, "lidar");
    EXPECT_EQ(result.output.problem != nullptr, i > 0);  // the first is registered to nothing
  }
  EXPECT_EQ(stage.account().processed, 3u);
}

TEST(OdometryStage, thePosesAreThoseOfTheOdometryWithAndWithoutInformation) {
  const Drive drive = driveInRoom(8);
  SlamConfig without = roomSlam();
  without.information.enabled = false;
  OdometryStage with_stage(roomSlam()), without_stage(without);
  Odometry odometry(roomConfig());
  for (const Scan& scan : drive.scans) {
    const auto expected = odometry.registerScan(scan).scan->T_odom_base.matrix();
    EXPECT_EQ(with_stage.process(readingOf(scan)).output.scan->T_odom_base.matrix(), expected);
    const auto output = without_stage.process(readingOf(scan)).output;
    EXPECT_EQ(output.scan->T_odom_base.matrix(), expected);
    EXPECT_FALSE(output.problem);
  }
}

TEST(OdometryStage, accountsForEveryReading) {
  const Drive drive = driveInRoom(2);
  OdometryStage stage(roomSlam());
  stage.process(readingOf(drive.scans[0]));
  EXPECT_EQ(stage.process(readingOf(drive.scans[0])).rejection, "duplicate stamp");
  EXPECT_EQ(stage.process(ScanReading{}).rejection.empty(), false);
  stage.countDropped("queue full");
  const ScanAccount& account = stage.account();
  EXPECT_EQ(account.received, 4u);
  EXPECT_EQ(account.processed + account.droppedInAll(), account.received);
  EXPECT_EQ(account.dropped.at("duplicate stamp"), 1u);
}

TEST(OdometryStage, aNewSessionStartsFromTheIdentity) {
  const Drive drive = driveInRoom(4);
  OdometryStage stage(roomSlam(), SessionId{5});
  for (const Scan& scan : drive.scans) stage.process(readingOf(scan));
  stage.startSession();
  const auto output = stage.process(readingOf(drive.scans[0])).output;  // older, and welcome
  ASSERT_TRUE(output.scan);
  EXPECT_EQ(output.scan->id, (ScanId{0, SessionId{6}}));
  EXPECT_EQ(output.scan->T_odom_base.matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(stage.account().received, 1u);
}

}  // namespace
}  // namespace revisit_slam
