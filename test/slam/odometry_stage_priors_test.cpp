// SPDX-License-Identifier: MIT
// Scans that wait for measured motion.
#include <gtest/gtest.h>

#include "revisit_slam/slam/odometry_stage.h"
#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

SlamConfig withWheels() {
  SlamConfig config;
  config.odometry = roomConfig();
  config.priors.odometry_topic = "/wheels";
  return config;
}

ScanReading readingOf(const Scan& scan) {
  ScanReading reading;
  reading.scan = scan;
  reading.counts.received = scan.points.size();
  return reading;
}

/// What perfect wheels say at the end of a sweep.
OdometryReading wheelsAt(const Drive& drive, std::size_t i) {
  OdometryReading reading;
  reading.stamp = drive.scans[i].stamp;
  reading.T_world_base = drive.T_first_base[i];
  return reading;
}

using Results = std::vector<OdometryStage::Result>;

void append(Results more, Results& results) {
  for (OdometryStage::Result& result : more) results.push_back(std::move(result));
}

TEST(OdometryStageWithPriors, AScanWaitsForTheReadingsUpToItsEnd) {
  const Drive drive = driveInRoom(3);
  OdometryStage stage(withWheels());
  EXPECT_TRUE(stage.process(readingOf(drive.scans[0])).empty());
  EXPECT_EQ(stage.held(), 1u);
  EXPECT_EQ(stage.takeMotion(wheelsAt(drive, 0)).size(), 1u);
  EXPECT_TRUE(stage.takeMotion(wheelsAt(drive, 1)).empty());
  EXPECT_EQ(stage.process(readingOf(drive.scans[1])).size(), 1u);  // it is there already
  EXPECT_EQ(stage.priors().accounts().at("odometry").used, 1u);
}

/// Scans before their readings, behind them, and in bursts.
TEST(OdometryStageWithPriors, TheOrderInWhichTopicsArriveChangesNothing) {
  const Drive drive = driveInRoom(24);
  const auto run = [&](std::size_t late) {
    OdometryStage stage(withWheels());
    Results results;
    for (std::size_t i = 0; i < drive.scans.size() + late; ++i) {
      if (i < drive.scans.size()) append(stage.process(readingOf(drive.scans[i])), results);
      if (i >= late) append(stage.takeMotion(wheelsAt(drive, i - late)), results);
    }
    return results;
  };
  const Results expected = run(0);
  ASSERT_EQ(expected.size(), drive.scans.size());
  for (const std::size_t late : {1u, 3u}) {
    const Results results = run(late);
    ASSERT_EQ(results.size(), expected.size());
    for (std::size_t i = 0; i < results.size(); ++i)
      EXPECT_EQ(results[i].output.scan->T_odom_base.matrix(),
                expected[i].output.scan->T_odom_base.matrix());
  }
}

TEST(OdometryStageWithPriors, ASensorThatStopsDelaysScansOnceAndIsAnnounced) {
  const Drive drive = driveInRoom(30);
  OdometryStage stage(withWheels());
  std::size_t most_waiting = 0, announced = 0;
  Results results;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    if (i < 10) append(stage.takeMotion(wheelsAt(drive, i)), results);
    append(stage.process(readingOf(drive.scans[i])), results);
    most_waiting = std::max(most_waiting, stage.held());
    EXPECT_TRUE(i <= 20 || stage.held() == 0u) << i;
  }
  for (const OdometryStage::Result& result : results)
    announced += result.notice.find("no messages of odometry") != std::string::npos;
  EXPECT_EQ(results.size(), drive.scans.size());
  EXPECT_LE(most_waiting, 5u);
  EXPECT_EQ(announced, 1u);
  EXPECT_TRUE(stage.priors().accounts().at("odometry").is_silent);
  EXPECT_EQ(stage.priors().accounts().at("odometry").missing, 20u);
  EXPECT_LT(distanceBetween(results.back().output.scan->T_odom_base, drive.T_first_base.back()),
            0.1);
}

TEST(OdometryStageWithPriors, MissingDoubledAndLateReadingsDoNoHarm) {
  const Drive drive = driveInRoom(30);
  OdometryStage stage(withWheels());
  Results results;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    append(stage.process(readingOf(drive.scans[i])), results);
    if (i % 7 == 3) continue;  // missing
    append(stage.takeMotion(wheelsAt(drive, i)), results);
    if (i % 5 == 0) append(stage.takeMotion(wheelsAt(drive, i)), results);      // doubled
    if (i % 6 == 5) append(stage.takeMotion(wheelsAt(drive, i - 1)), results);  // late
  }
  append(stage.flush(), results);
  ASSERT_EQ(results.size(), drive.scans.size());
  for (std::size_t i = 0; i < results.size(); ++i)
    EXPECT_LT(distanceBetween(results[i].output.scan->T_odom_base, drive.T_first_base[i]), 0.08);
  EXPECT_GT(stage.priors().accounts().at("odometry").dropped.at("duplicate stamp"), 0u);
  EXPECT_GT(stage.priors().accounts().at("odometry").dropped.at("out of order"), 0u);
}

TEST(OdometryStageWithPriors, AtTheEndNothingIsWaitedFor) {
  const Drive drive = driveInRoom(2);
  OdometryStage stage(withWheels());
  stage.process(readingOf(drive.scans[0]));
  stage.process(readingOf(drive.scans[1]));
  EXPECT_EQ(stage.flush().size(), 2u);
  EXPECT_EQ(stage.held(), 0u);
}

/// A wrong diameter, from the first scan: what is measured must not hold the registration.
TEST(OdometryStageWithPriors, WheelsThatMeasureTooMuchFromTheStartDoNotPull) {
  const Drive drive = driveInRoom(40);
  OdometryStage stage(withWheels());
  Results results;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    OdometryReading wheels = wheelsAt(drive, i);
    wheels.T_world_base.translation *= 1.3;
    append(stage.takeMotion(wheels), results);
    append(stage.process(readingOf(drive.scans[i])), results);
  }
  const Pose T_first_last = drive.T_first_base.front().inverse() * drive.T_first_base.back();
  EXPECT_LT(distanceBetween(results.back().output.scan->T_odom_base, T_first_last), 0.1);
}

/// Where the registration has nothing to hold on to.
TEST(OdometryStageWithPriors, WhereLittleMatchesThePoseIsThatOfTheWheels) {
  const Drive drive = driveInRoom(20);
  SlamConfig config = withWheels();
  config.odometry.registration.min_correspondences = 100000;
  OdometryStage stage(config);
  Results results;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    append(stage.takeMotion(wheelsAt(drive, i)), results);
    append(stage.process(readingOf(drive.scans[i])), results);
  }
  const Pose T_first_last = drive.T_first_base.front().inverse() * drive.T_first_base.back();
  EXPECT_LT(distanceBetween(results.back().output.scan->T_odom_base, T_first_last), 0.1);
}

}  // namespace
}  // namespace revisit_slam
