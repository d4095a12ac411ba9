// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/odometry.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/synthetic_drive.h"
#include "support/threads.h"

namespace revisit_slam {
namespace {

TEST(Odometry, FollowsADriveAlsoWhenScansAreDropped) {
  const Drive drive = driveInRoom(40);
  for (const bool drop : {false, true}) {
    Odometry odometry(roomConfig());
    std::uint32_t expected_id = 0;
    for (std::size_t i = 0; i < drive.scans.size(); ++i) {
      if (drop && i > 12 && i % 4 != 0) continue;  // up to 0.4 s and 1.6 m without a scan
      const auto result = odometry.registerScan(drive.scans[i]);
      ASSERT_EQ(result.outcome, OdometryOutcome::registered);
      EXPECT_EQ(result.scan->id.value, expected_id++);
      EXPECT_EQ(result.scan->stamp, drive.scans[i].stamp);
      EXPECT_TRUE(result.scan->deskewed);
      EXPECT_LT(distanceBetween(result.scan->T_odom_base, drive.T_first_base[i]), 0.08) << i;
      if (i > 30) {
        EXPECT_LT((result.scan->velocity_base - drive.last_velocity).norm(), 0.4) << i;
      }
    }
  }
}

TEST(Odometry, StartingInMotionDeskewsTheSecondScanAsIfTheMotionHadBeenKnown) {
  const Drive drive = driveInRoom(20);
  Odometry warm(roomConfig()), cold(roomConfig());
  OdometryResult expected;
  for (const Scan& scan : drive.scans) expected = warm.registerScan(scan);
  cold.registerScan(drive.scans[18]);
  const OdometryResult second = cold.registerScan(drive.scans[19]);
  const Points &a = second.scan->points_base, &b = expected.scan->points_base;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LT((a[i] - b[i]).norm(), 0.1f) << i;
  EXPECT_LT(distanceBetween(second.scan->T_odom_base,
                            drive.T_first_base[18].inverse() * drive.T_first_base[19]),
            0.03);
}

TEST(Odometry, TakesTheFirstScansAsTheyAreWhereItIsAsked) {
  const Drive drive = driveInRoom(20);
  OdometryConfig config = roomConfig();
  config.redo_first_scans = false;
  Odometry once(config), again(roomConfig());
  OdometryResult first, second;
  for (const std::size_t i : {18u, 19u}) {
    first = once.registerScan(drive.scans[i]);
    second = again.registerScan(drive.scans[i]);
  }
  const Points as_it_is = preprocess(drive.scans[19], ConstantMotion(), config).points_base;
  EXPECT_EQ(first.scan->points_base, as_it_is);
  EXPECT_NE(second.scan->points_base, as_it_is);
}

TEST(Odometry, TakesPointsInTheOrderOfAHashTableWhereItIsAsked) {
  const Scan scan = driveInRoom(1).scans[0];
  OdometryConfig config = roomConfig();
  config.sampling = "hash";
  const RegisteredScan registered = *Odometry(config).registerScan(scan).scan;
  Points for_map, expected;
  VoxelFilter filter;
  filter.filterHashed(registered.points_base, 0.5 * config.map.voxel_size, for_map);
  filter.filterHashed(for_map, 1.5 * config.map.voxel_size, expected);
  EXPECT_EQ(registered.source_base, expected);
  EXPECT_NE(Odometry(roomConfig()).registerScan(scan).scan->source_base, expected);
}

TEST(Odometry, DeskewsWithTheMotionOfTheScanItself) {
  const Drive drive = walkInRoom(40);
  const auto meanErrorOfMotions = [&](double deskew_gain) {
    OdometryConfig config = roomConfig();
    config.registration.deskew_gain = deskew_gain;
    Odometry odometry(config);
    Pose T_odom_before;
    double sum = 0.0;
    for (std::size_t i = 0; i < drive.scans.size(); ++i) {
      const Pose T_odom_base = odometry.registerScan(drive.scans[i]).scan->T_odom_base;
      if (i >= 10)
        sum += distanceBetween(T_odom_before.inverse() * T_odom_base,
                               drive.T_first_base[i - 1].inverse() * drive.T_first_base[i]);
      T_odom_before = T_odom_base;
    }
    return sum / static_cast<double>(drive.scans.size() - 10);
  };
  EXPECT_LT(meanErrorOfMotions(RegistrationConfig{}.deskew_gain), 0.5 * meanErrorOfMotions(0.0));
}

TEST(Odometry, HandsOnPointsThatAreDeskewedWithTheMotionOfTheScanItself) {
  const Drive drive = walkInRoom(40);
  const Scan& last = drive.scans.back();
  const Points truth =
      preprocess(last, ConstantMotion(drive.last_velocity), roomConfig()).points_base;
  const auto meanErrorOfPoints = [&](double deskew_gain) {
    OdometryConfig config = roomConfig();
    config.registration.deskew_gain = deskew_gain;
    Odometry odometry(config);
    OdometryResult result;
    for (const Scan& scan : drive.scans) result = odometry.registerScan(scan);
    const Points& points = result.scan->points_base;
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) sum += (points.at(i) - truth[i]).norm();
    return sum / static_cast<double>(truth.size());
  };
  EXPECT_LT(meanErrorOfPoints(RegistrationConfig{}.deskew_gain), 0.6 * meanErrorOfPoints(0.0));
}

TEST(Odometry, StartsWhereItIs) {
  const auto result = Odometry(roomConfig()).registerScan(driveInRoom(1).scans[0]);
  EXPECT_EQ(result.scan->registration.outcome, RegistrationOutcome::map_empty);
  EXPECT_EQ(result.scan->T_odom_base.matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(result.scan->velocity_base, Tangent::Zero());
  EXPECT_LT(result.scan->source_base.size(), result.scan->points_base.size());
}

TEST(Odometry, FindsItsPlaceAgainAfterAGap) {
  const Drive drive = driveInRoom(60);
  Odometry odometry(roomConfig());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    if (i > 25 && i < 50) continue;  // 2.5 s, 10 m and 57 degrees
    const auto result = odometry.registerScan(drive.scans[i]);
    ASSERT_EQ(result.outcome, OdometryOutcome::registered);
    EXPECT_EQ(result.scan->verdict, PoseVerdict::good) << i;
    EXPECT_LT(distanceBetween(result.scan->T_odom_base, drive.T_first_base[i]), 0.12) << i;
  }
}

TEST(Odometry, ACarriedSensorIsLostAndGoesOnInANewPieceOfMap) {
  const Drive drive = driveInRoom(50);
  Odometry odometry(roomConfig());
  Pose T_odom_before;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    Scan scan = drive.scans[i];
    const bool is_elsewhere = i >= 25;  // in a high and narrow hall
    for (Eigen::Vector3f& point : scan.points)
      if (is_elsewhere) point = {0.4f * point.x(), 0.4f * point.y(), 3.0f * point.z()};
    const auto result = odometry.registerScan(scan);
    ASSERT_EQ(result.outcome, OdometryOutcome::registered);
    const RegisteredScan& registered = *result.scan;
    EXPECT_EQ(registered.verdict, i == 25 ? PoseVerdict::lost : PoseVerdict::good) << i;
    if (i == 25) {
      EXPECT_EQ(registered.registration.outcome, RegistrationOutcome::no_fit);
      const Matrix6 covariance = registered.prior_information.inverse();
      EXPECT_GT(std::sqrt(covariance(0, 0)), roomConfig().max_range);
    }
    if (i > 30) {
      const Pose step = T_odom_before.inverse() * registered.T_odom_base;
      EXPECT_NEAR(step.translation.norm(), 0.16, 0.05) << i;  // 0.4 of 4 m/s
    }
    T_odom_before = registered.T_odom_base;
  }
}

/// Of a scan whose points more than `left` to the left are so many times as far away.
PoseVerdict verdictWhere(double times, float left, const OdometryConfig& config) {
  const Drive drive = driveInRoom(26);
  Odometry odometry(config);
  for (int i = 0; i < 25; ++i) odometry.registerScan(drive.scans[i]);
  Scan scan = drive.scans[25];
  for (Eigen::Vector3f& point : scan.points)
    if (point.y() > left) point *= static_cast<float>(times);
  return odometry.registerScan(scan).scan->verdict;
}

/// Rays end behind walls: this is another room. What comes near is something in the way.
TEST(Odometry, APoorScanThatSeesThroughWallsIsLost) {
  OdometryConfig never = roomConfig();
  never.fit.through = 0.0;
  EXPECT_EQ(verdictWhere(1.6, 3.0f, never), PoseVerdict::poor);
  EXPECT_EQ(verdictWhere(1.6, 3.0f, roomConfig()), PoseVerdict::lost);
  EXPECT_EQ(verdictWhere(0.6, 0.0f, roomConfig()), PoseVerdict::poor);
}

TEST(Odometry, RejectedScansChangeNothing) {
  const Drive drive = driveInRoom(12);
  Scan duplicate = drive.scans[3], older = drive.scans[2], empty, far, near;
  older.stamp = drive.scans[5].stamp.plusSeconds(-1e-9);
  empty.stamp = far.stamp = near.stamp = drive.scans[5].stamp.plusSeconds(0.05);
  far.points = Points(50, {70, 0, 0});
  near.points = Points(30, {0.1f, 0, 0});
  duplicate.stamp = drive.scans[5].stamp;
  Odometry with(roomConfig()), without(roomConfig());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const auto a = with.registerScan(drive.scans[i]), b = without.registerScan(drive.scans[i]);
    EXPECT_EQ(a.scan->T_odom_base.matrix(), b.scan->T_odom_base.matrix()) << i;
    EXPECT_EQ(a.scan->id, b.scan->id);
    EXPECT_EQ(a.scan->sigma, b.scan->sigma);
    EXPECT_EQ(a.scan->points_base, b.scan->points_base);
    if (i != 5) continue;
    for (const auto& [scan, outcome] : {std::pair{&duplicate, OdometryOutcome::duplicate_stamp},
                                        {&older, OdometryOutcome::time_went_back},
                                        {&empty, OdometryOutcome::no_point_in_range},
                                        {&far, OdometryOutcome::no_point_in_range},
                                        {&near, OdometryOutcome::no_point_in_range}}) {
      const auto rejected = with.registerScan(*scan);
      EXPECT_EQ(rejected.outcome, outcome) << toString(rejected.outcome);
      EXPECT_FALSE(rejected.scan);
    }
    EXPECT_EQ(with.registerScan(far).too_far, 50u);
    EXPECT_EQ(with.registerScan(near).too_near, 30u);
  }
  EXPECT_EQ(with.map().points(), without.map().points());
}

TEST(Odometry, GivesTheSameBitsForAnyNumberOfThreads) {
  const Drive drive = driveInRoom(10);
  Odometry one(roomConfig()), two(roomConfig()), four(roomConfig());
  const auto poseOn = [](int threads, Odometry& odometry, const Scan& scan) {
    return onThreads(threads,
                     [&] { return odometry.registerScan(scan).scan->T_odom_base.matrix(); });
  };
  for (const Scan& scan : drive.scans) {
    const auto expected = poseOn(1, one, scan);
    EXPECT_EQ(poseOn(2, two, scan), expected);
    EXPECT_EQ(poseOn(4, four, scan), expected);
  }
  EXPECT_EQ(four.map().points(), one.map().points());
}

TEST(Odometry, TheMapStaysAsItWasUntilTheScanIsCommitted) {
  const Drive drive = driveInRoom(6);
  Odometry odometry(roomConfig());
  for (std::size_t i = 0; i < 5; ++i) odometry.registerScan(drive.scans[i]);
  const Points before = odometry.map().points();
  const OdometryResult aligned = odometry.align(drive.scans[5]);
  ASSERT_TRUE(aligned.scan);
  EXPECT_EQ(odometry.map().points(), before);
  odometry.commit();
  EXPECT_NE(odometry.map().points(), before);
  EXPECT_EQ(odometry.align(drive.scans[5]).outcome, OdometryOutcome::duplicate_stamp);
}

TEST(Odometry, AScanThatIsNotCommittedHasNotBeen) {
  const Drive drive = driveInRoom(6);
  Odometry with(roomConfig()), without(roomConfig());
  for (std::size_t i = 0; i < 5; ++i) {
    with.registerScan(drive.scans[i]);
    without.registerScan(drive.scans[i]);
  }
  with.align(drive.scans[4 + 1]);  // dropped
  Scan last = drive.scans[5];
  EXPECT_EQ(with.registerScan(last).scan->T_odom_base.matrix(),
            without.registerScan(last).scan->T_odom_base.matrix());
}

/// The drive in the hall of 40 x 30 m, everything a tenth as large.
TEST(Odometry, FollowsADriveInASmallRoomWithTheDefaults) {
  Drive drive = driveInRoom(40);
  OdometryConfig config;
  config.min_range = 0.05;
  Odometry odometry(config);
  OdometryResult result;
  for (Scan& scan : drive.scans) {
    for (Eigen::Vector3f& point : scan.points) point *= 0.1f;
    scan.T_base_sensor.translation *= 0.1;
    result = odometry.registerScan(scan);
    EXPECT_LE(result.scan->voxel_size, 0.125);
  }
  Pose truth = drive.T_first_base.back();
  truth.translation *= 0.1;
  EXPECT_LT(distanceBetween(result.scan->T_odom_base, truth), 0.03);
  EXPECT_EQ(odometry.map().voxelSize(), result.scan->voxel_size);
}

TEST(Odometry, KeepsTheLocalMapWhenItsVoxelsChange) {
  const Drive drive = driveInRoom(30);
  OdometryConfig config = roomConfig();
  config.map.voxel_size = 2.0;
  Odometry odometry(config);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const auto result = odometry.registerScan(drive.scans[i]);
    EXPECT_LT(distanceBetween(result.scan->T_odom_base, drive.T_first_base[i]), 0.1) << i;
  }
  EXPECT_LT(odometry.map().voxelSize(), 2.0);
  config.adaptive_voxel_size = false;
  Odometry fixed(config);
  fixed.registerScan(drive.scans[0]);
  EXPECT_EQ(fixed.map().voxelSize(), 2.0);
}

TEST(Odometry, TakesOverRangesBetweenScans) {
  const Drive drive = driveInRoom(2);
  OdometryConfig config = roomConfig();
  Odometry odometry(config);
  EXPECT_EQ(odometry.registerScan(drive.scans[0]).too_far, 0u);
  config.max_range = 10.0;
  config.deskew = false;
  odometry.reconfigure(config);
  const auto result = odometry.registerScan(drive.scans[1]);
  EXPECT_GT(result.too_far, 100u);
  EXPECT_FALSE(result.scan->deskewed);
}

}  // namespace
}  // namespace revisit_slam
