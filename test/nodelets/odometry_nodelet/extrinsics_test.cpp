// SPDX-License-Identifier: MIT
#include <tf2_ros/static_transform_broadcaster.h>

#include "in_process_odometry.h"
#include "support/contains.h"
#include "support/ros_log.h"

namespace revisit_slam {
namespace {

using Extrinsics = InProcessOdometry;

void expectNear(const Pose& T, const Pose& T_expected) {
  EXPECT_LT((T.translation - T_expected.translation).norm(), 0.05);
  EXPECT_LT((T.rotation.conjugate() * T_expected.rotation).vec().norm(), 0.01);
}

geometry_msgs::TransformStamped mounting(const std::string& base_frame, const Pose& T_base_sensor,
                                         const std::string& sensor_frame = "lidar") {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = base_frame;
  message.child_frame_id = sensor_frame;
  message.transform = toTransformMessage(T_base_sensor);
  return message;
}

TEST_F(Extrinsics, scansWaitForTheTransformWhichIsThenApplied) {
  const RosLog log;
  setParameter("frames/base", std::string("robot"));
  load();
  const Drive drive = driveInRoom(15);
  for (const auto& cloud : toClouds(drive)) publish(cloud);
  ASSERT_TRUE(listener_.diagnoses("scans waiting", 14));
  EXPECT_EQ(listener_.trajectory().size(), 0u);
  EXPECT_TRUE(contains(log.text(), "waiting for the transform from 'lidar' to 'robot'"));

  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(mounting("robot", drive.scans[0].T_base_sensor));
  ASSERT_TRUE(listener_.hasPoses(15));
  expectNear(listener_.trajectory().back().T_world_base, drive.T_first_base.back());
  EXPECT_TRUE(listener_.drops().empty());
}

TEST_F(Extrinsics, withoutBaseFrameThePoseIsTheSensors) {
  load();
  const Drive drive = driveInRoom(15);
  for (const auto& cloud : toClouds(drive)) publish(cloud);
  ASSERT_TRUE(listener_.hasPoses(15));
  const Pose& T_base_sensor = drive.scans[0].T_base_sensor;
  const Pose T_first_sensor = T_base_sensor.inverse() * drive.T_first_base.back() * T_base_sensor;
  EXPECT_GT((T_first_sensor.translation - drive.T_first_base.back().translation).norm(), 0.5);
  expectNear(listener_.trajectory().back().T_world_base, T_first_sensor);
}

TEST_F(Extrinsics, anUnknownFirstFrameIsDroppedAndDoesNotBlockTheOthers) {
  setParameter("frames/base", std::string("robot"));
  setParameter("live/transform_patience", 0.3);
  load();
  const Drive drive = driveInRoom(12);
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(mounting("robot", drive.scans[0].T_base_sensor));
  std::vector<sensor_msgs::PointCloud2> clouds = toClouds(drive);
  for (std::size_t i = 0; i < 2; ++i) clouds[i].header.frame_id = "another";
  for (const auto& cloud : clouds) publish(cloud);
  ASSERT_TRUE(listener_.hasPoses(10));
  ASSERT_TRUE(listener_.diagnoses("scans received", 12));
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"no transform from 'another'", 2}}));
}

TEST_F(Extrinsics, scansOfAKnownFrameDoNotWaitForAFirstOneThatIsNot) {
  setParameter("frames/base", std::string("robot"));
  setParameter("live/transform_patience", 3600.0);
  load();
  const Drive drive = driveInRoom(6);
  std::vector<sensor_msgs::PointCloud2> clouds = toClouds(drive);
  clouds[0].header.frame_id = "unknown";
  publish(clouds[0]);
  for (std::size_t i = 1; i < 4; ++i) publish(clouds[i]);  // not placed yet either
  ASSERT_TRUE(listener_.diagnoses("scans waiting", 3));
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(mounting("robot", drive.scans[0].T_base_sensor));
  for (std::size_t i = 4; i < 6; ++i) publish(clouds[i]);
  ASSERT_TRUE(listener_.hasPoses(5));
  ASSERT_TRUE(listener_.diagnoses("scans received", 6));
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"no transform from 'unknown'", 1}}));
}

/// Every second scan comes from a sensor that is mounted elsewhere; seen from the base all is one
/// drive.
TEST_F(Extrinsics, twoSensorsWithFramesOfTheirOwnArePlacedBothRightly) {
  setParameter("frames/base", std::string("robot"));
  load();
  const Drive drive = driveInRoom(16);
  const Pose T_base_lidar = drive.scans[0].T_base_sensor;
  const Pose T_lidar_rear{expSO3({0, 0, M_PI / 2}), {-1.0, 0.5, 0.2}};
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(mounting("robot", T_base_lidar));
  broadcaster.sendTransform(mounting("robot", T_base_lidar * T_lidar_rear, "rear"));
  Drive seen = drive;
  for (std::size_t i = 1; i < seen.scans.size(); i += 2)
    for (Eigen::Vector3f& p : seen.scans[i].points)
      p = (T_lidar_rear.inverse() * Eigen::Vector3d(p.cast<double>())).cast<float>();
  std::vector<sensor_msgs::PointCloud2> clouds = toClouds(seen);
  for (std::size_t i = 1; i < clouds.size(); i += 2) clouds[i].header.frame_id = "rear";
  for (const auto& cloud : clouds) publish(cloud);
  ASSERT_TRUE(listener_.hasPoses(16));
  expectNear(listener_.trajectory().back().T_world_base, drive.T_first_base.back());
}

TEST_F(Extrinsics, aTransformThatChangesIsFollowedAndSaidSo) {
  const RosLog log;
  setParameter("frames/base", std::string("robot"));
  load();
  const Drive drive = driveInRoom(3);
  tf2_ros::StaticTransformBroadcaster broadcaster;
  const std::vector<sensor_msgs::PointCloud2> clouds = toClouds(drive);
  Pose T_base_sensor = drive.scans[0].T_base_sensor;
  broadcaster.sendTransform(mounting("robot", T_base_sensor));
  publish(clouds[0]);
  ASSERT_TRUE(listener_.hasPoses(1));
  T_base_sensor.translation.z() += 0.5;
  broadcaster.sendTransform(mounting("robot", T_base_sensor));
  ASSERT_TRUE(becomesTrue([&] {
    publish(clouds[1]);
    return contains(log.text(), "the transform from 'lidar' to 'robot' has changed");
  }));
}

TEST_F(Extrinsics, nodeletEndsWhileItWaits) {
  setParameter("frames/base", std::string("never_known"));
  load();
  for (const auto& cloud : toClouds(driveInRoom(2))) publish(cloud);
  ASSERT_TRUE(listener_.diagnoses("scans waiting", 1));
  EXPECT_TRUE(loader_.unload(space_ + "odometry"));
}

}  // namespace
}  // namespace revisit_slam
