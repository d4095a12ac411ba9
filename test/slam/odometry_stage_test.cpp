// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/odometry_stage.h"

#include <gtest/gtest.h>

#include "support/contains.h"
#include "support/sweep_parts.h"
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

OdometryStage::Result processOne(OdometryStage& stage, ScanReading reading) {
  const std::vector<OdometryStage::Result> results = stage.process(std::move(reading));
  EXPECT_EQ(results.size(), 1u);
  return results.empty() ? OdometryStage::Result{} : results.front();
}

TEST(OdometryStage, handsOnScansWithTheirRegistrationProblem) {
  const Drive drive = driveInRoom(3);
  OdometryStage stage(roomSlam(), SessionId{5});
  for (std::uint32_t i = 0; i < 3; ++i) {
    const OdometryStage::Result result = processOne(stage, readingOf(drive.scans[i]));
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
    EXPECT_EQ(processOne(with_stage, readingOf(scan)).output.scan->T_odom_base.matrix(), expected);
    const auto output = processOne(without_stage, readingOf(scan)).output;
    EXPECT_EQ(output.scan->T_odom_base.matrix(), expected);
    EXPECT_FALSE(output.problem);
  }
}

TEST(OdometryStage, saysWhenTheVoxelsOfTheLocalMapChange) {
  Drive drive = driveInRoom(2);
  OdometryStage stage(roomSlam());
  EXPECT_EQ(processOne(stage, readingOf(drive.scans[0])).notice, "");
  stage.startSession();
  for (Eigen::Vector3f& point : drive.scans[0].points) point *= 0.1f;
  EXPECT_NE(processOne(stage, readingOf(drive.scans[0])).notice.find("voxels"), std::string::npos);
  EXPECT_EQ(processOne(stage, readingOf(drive.scans[1])).notice, "");
}

TEST(OdometryStage, accountsForEveryReading) {
  const Drive drive = driveInRoom(2);
  OdometryStage stage(roomSlam());
  stage.process(readingOf(drive.scans[0]));
  EXPECT_EQ(processOne(stage, readingOf(drive.scans[0])).rejection, "duplicate stamp");
  EXPECT_EQ(processOne(stage, ScanReading{}).rejection.empty(), false);
  stage.countDropped("queue full");
  const ScanAccount& account = stage.account();
  EXPECT_EQ(account.received, 4u);
  EXPECT_EQ(account.processed + account.droppedInAll(), account.received);
  EXPECT_EQ(account.dropped.at("duplicate stamp"), 1u);
}

TEST(OdometryStage, scansOfABaseThatRestsRepeatAnId) {
  const Drive drive = driveInRoomWith([](int) -> Tangent { return Tangent::Zero(); }, 45);
  OdometryStage stage(roomSlam());
  std::vector<std::uint32_t> ids;
  for (const Scan& scan : drive.scans)
    ids.push_back(processOne(stage, readingOf(scan)).output.scan->id.value);
  EXPECT_EQ(ids[29], 29u);  // 3 s
  for (std::size_t i = 30; i < 45; ++i) EXPECT_EQ(ids[i], 29u) << i;
  EXPECT_EQ(stage.account().processed, 45u);
  EXPECT_EQ(stage.account().at_rest, 15u);
  stage.startSession();
  EXPECT_EQ(processOne(stage, readingOf(drive.scans[0])).output.scan->id.value, 0u);
}

TEST(OdometryStage, aBaseThatIsCarriedWhileItRestsIsNoLongerWhereItWas) {
  Scan scan = driveInRoom(1).scans[0];
  OdometryStage stage(roomSlam());
  int repeated = 0;
  for (int i = 0; i < 60; ++i) {
    if (i == 50)  // into a high and narrow hall
      for (Eigen::Vector3f& point : scan.points)
        point = {0.4f * point.x(), 0.4f * point.y(), 3.0f * point.z()};
    const auto account = stage.account().at_rest;
    const auto output = processOne(stage, readingOf(scan)).output;
    repeated += stage.account().at_rest > account ? 1 : 0;
    scan.stamp = scan.stamp.plusSeconds(0.1);
    if (i < 50) continue;
    EXPECT_EQ(output.scan->verdict, i == 50 ? PoseVerdict::lost : PoseVerdict::good) << i;
    EXPECT_EQ(stage.account().at_rest, account) << i;
  }
  EXPECT_GT(repeated, 10);
}

TEST(OdometryStage, joinsPartsToTheSweepsThatTheyAreOf) {
  const Drive drive = driveInRoom(12);
  OdometryStage whole_stage(roomSlam()), parts_stage(roomSlam());
  std::vector<OdometryStage::Result> whole, parts;
  for (const Scan& scan : drive.scans)
    for (auto& result : whole_stage.process(partsOf(scan, 1).front())) whole.push_back(result);
  for (const ScanReading& part : partsOf(drive.scans, 3))
    for (auto& result : parts_stage.process(part)) parts.push_back(result);
  ASSERT_EQ(parts.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    ASSERT_TRUE(parts[i].output.scan);
    EXPECT_TRUE(parts[i].output.scan->deskewed);
    EXPECT_LT(distanceBetween(parts[i].output.scan->T_odom_base, whole[i].output.scan->T_odom_base),
              1e-3);
  }
  EXPECT_TRUE(contains(parts.front().notice, "hold parts of sweeps"));
  EXPECT_EQ(parts.back().notice, "");
  EXPECT_EQ(parts_stage.account().received, 36u);
  EXPECT_EQ(parts_stage.account().processed, 12u);
  EXPECT_EQ(parts_stage.account().joined, 24u);
}

TEST(OdometryStage, aNewSessionStartsFromTheIdentity) {
  const Drive drive = driveInRoom(4);
  OdometryStage stage(roomSlam(), SessionId{5});
  for (const Scan& scan : drive.scans) stage.process(readingOf(scan));
  stage.startSession();
  const auto output = processOne(stage, readingOf(drive.scans[0])).output;  // older, and welcome
  ASSERT_TRUE(output.scan);
  EXPECT_EQ(output.scan->id, (ScanId{0, SessionId{6}}));
  EXPECT_EQ(output.scan->T_odom_base.matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(stage.account().received, 1u);
}

TEST(OdometryStage, aClockSetBackBeginsASessionAndLosesNoScan) {
  const Drive drive = driveInRoom(20);
  OdometryStage stage(roomSlam(), SessionId{5});
  std::vector<OdometryStage::Result> results;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    Scan scan = drive.scans[i];
    if (i < 10) scan.stamp = scan.stamp.plusSeconds(3600.0);
    for (OdometryStage::Result& result : stage.process(readingOf(scan)))
      results.push_back(std::move(result));
  }
  ASSERT_EQ(results.size(), 20u);
  for (std::uint32_t i = 0; i < 20; ++i)
    EXPECT_EQ(results[i].output.scan->id, (ScanId{i % 10, SessionId{5 + i / 10}})) << i;
  EXPECT_NE(results[10].notice.find("a new session begins"), std::string::npos);
  EXPECT_EQ(results[10].output.scan->T_odom_base.matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(stage.account().processed, 20u);
}

TEST(OdometryStage, oneStampAheadCostsThatScanAlone) {
  const Drive drive = driveInRoom(20);
  OdometryStage stage(roomSlam());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    Scan scan = drive.scans[i];
    if (i == 7) scan.stamp = scan.stamp.plusSeconds(3600.0);
    stage.process(readingOf(scan));
  }
  EXPECT_EQ(stage.account().processed, 19u);
  EXPECT_EQ(stage.account().dropped.at("stamp ahead of the next one"), 1u);
}

}  // namespace
}  // namespace revisit_slam
