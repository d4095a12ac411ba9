// SPDX-License-Identifier: MIT
// GNSS, gravity, and several LiDARs.
#include <gtest/gtest.h>

#include "revisit_slam/slam/odometry_stage.h"
#include "support/synthetic_drive.h"

namespace revisit_slam {
namespace {

SlamConfig roomStage() {
  SlamConfig config;
  config.odometry = roomConfig();
  return config;
}

ScanReading readingOf(const Scan& scan, std::size_t sensor = 0) {
  ScanReading reading;
  reading.scan = scan;
  reading.sensor = sensor;
  reading.counts.received = scan.points.size();
  return reading;
}

GnssReading positionAt(Stamp stamp) {
  GnssReading reading;
  reading.stamp = stamp;
  reading.position = {48.0, 11.0, 500.0};
  reading.p_base = {0.0, 0.0, 1.0};
  return reading;
}

TEST(OdometryStageWithGnss, PositionsGoWithALaterScanAndScansDoNotWaitForThem) {
  SlamConfig config = roomStage();
  config.gnss.topic = "/fix";
  config.gnss.max_delay = 0.35;
  config.gnss.spacing = 0.0;
  config.mapping.rest_interval = 0.0;
  const Drive drive = driveInRoom(12);
  OdometryStage stage(config);
  std::vector<GnssFix> fixes;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    if (i == 2) stage.takeMotion(positionAt(drive.scans[1].stamp.plusSeconds(0.01)));
    const auto results = stage.process(readingOf(drive.scans[i]));
    ASSERT_EQ(results.size(), 1u) << i;
    for (const GnssFix& fix : results[0].output.scan->fixes) {
      EXPECT_EQ(i, 5u);
      fixes.push_back(fix);
    }
  }
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_EQ(fixes[0].scan.value, 1u);
  EXPECT_LT((fixes[0].p_scan - Eigen::Vector3d(0.0, 0.0, 1.0)).norm(), 0.2);
  EXPECT_EQ(stage.sensorAccounts().at("gnss").used, 1u);
  stage.countDroppedMotion("gnss", "no fix");
  EXPECT_EQ(stage.sensorAccounts().at("gnss").dropped.at("no fix"), 1u);
}

/// A base that stands, tilted.
TEST(OdometryStageWithGravity, ADirectionGoesWithTheScanThatEndsItsWindow) {
  SlamConfig config = roomStage();
  config.priors.imu_topic = "/imu";
  config.gravity.window = 1.0;
  config.mapping.rest_interval = 0.0;
  Scan scan = driveInRoom(1).scans[0];
  const Eigen::Vector3d up_base = Eigen::Vector3d(0.1, -0.05, 1.0).normalized();
  OdometryStage stage(config);
  std::vector<std::uint32_t> tied, carriers;
  const auto take = [&](const std::vector<OdometryStage::Result>& results) {
    for (const OdometryStage::Result& result : results) {
      ASSERT_TRUE(result.output.scan);
      const auto& gravity = result.output.scan->gravity;
      if (!gravity) continue;
      carriers.push_back(result.output.scan->id.value);
      tied.push_back(gravity->scan.value);
      EXPECT_LT((gravity->up_base - up_base).norm(), 0.01);
    }
  };
  for (int i = 0; i < 25; ++i) {
    for (int k = -9; k <= 0; ++k) {  // until the scan's stamp
      ImuReading reading;
      reading.stamp = scan.stamp.plusSeconds(0.01 * k);
      reading.acceleration = 9.81 * up_base;
      take(stage.takeMotion(reading));
    }
    take(stage.process(readingOf(scan)));
    scan.stamp = scan.stamp.plusSeconds(0.1);
  }
  EXPECT_EQ(tied, (std::vector<std::uint32_t>{5, 15}));
  EXPECT_EQ(carriers, (std::vector<std::uint32_t>{10, 20}));
  EXPECT_EQ(stage.sensorAccounts().at("gravity").used, 2u);
}

TEST(OdometryStageWithGnss, WithoutATopicThereIsNoAccount) {
  EXPECT_TRUE(OdometryStage(roomStage()).sensorAccounts().empty());
}

/// As of a sensor that TF places in the map.
TEST(OdometryStageWithLidars, ALeverOfHundredsOfMetresIsNamedAsAWrongTransform) {
  OdometryStage stage(roomStage());
  ScanReading reading = readingOf(driveInRoom(1).scans[0]);
  reading.frame_id = "lidar";
  reading.scan->T_base_sensor.translation = {300.0, -400.0, 0.0};
  const auto results = stage.process(reading);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].rejection,
            "wrong transform: frame 'lidar' is 500 m from the base frame; its transform has to be "
            "that of the sensor on the robot");
  EXPECT_EQ(stage.account().dropped.at("wrong transform"), 1u);
}

/// The points of each scan in turn to one of two sensors, one of them turned round.
TEST(OdometryStageWithLidars, HalvesOfAScanAreRegisteredAsTheWhole) {
  const Drive drive = driveInRoom(20);
  SlamConfig config = roomStage();
  OdometryStage whole(config);
  config.input.topics = "/front /rear";
  OdometryStage merged(config);
  const Pose T_base_rear{expSO3({0.0, 0.0, M_PI}), {-1.0, 0.0, 0.0}};
  std::vector<RegisteredScanPtr> expected, registered;
  for (const Scan& scan : drive.scans) {
    for (const auto& result : whole.process(readingOf(scan)))
      expected.push_back(result.output.scan);
    std::vector<Scan> halves(2);
    halves[0].stamp = halves[1].stamp = scan.stamp;
    halves[1].T_base_sensor = T_base_rear;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      Scan& half = halves[i % 2];
      const Eigen::Vector3d p_base = scan.T_base_sensor * scan.points[i].cast<double>();
      half.points.push_back((half.T_base_sensor.inverse() * p_base).cast<float>());
      half.times.push_back(scan.times.at(i));
    }
    for (std::size_t sensor = 0; sensor < 2; ++sensor)
      for (const auto& result : merged.process(readingOf(halves[sensor], sensor)))
        registered.push_back(result.output.scan);
  }
  for (const auto& result : merged.flush()) registered.push_back(result.output.scan);
  ASSERT_GE(registered.size() + 1, expected.size());
  EXPECT_EQ(registered.back()->views.size(), 2u);
  EXPECT_NEAR(secondsBetween(registered.back()->stamp, expected.back()->stamp), 0.0, 0.005);
  const std::size_t late = expected.size() - registered.size();
  const Pose moved = registered.front()->T_odom_base.inverse() * registered.back()->T_odom_base;
  const Pose wanted = expected[late]->T_odom_base.inverse() * expected.back()->T_odom_base;
  EXPECT_LT((moved.translation - wanted.translation).norm(), 0.05);
  EXPECT_EQ(merged.account().received, registered.size());
  EXPECT_EQ(merged.lidarAccounts().at("/rear").messages, drive.scans.size());
}

}  // namespace
}  // namespace revisit_slam
