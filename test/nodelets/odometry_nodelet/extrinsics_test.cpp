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

geometry_msgs::TransformStamped mounting(const std::string& base_frame, const Pose& T_base_sensor) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = base_frame;
  message.child_frame_id = "lidar";
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

TEST_F(Extrinsics, nodeletEndsWhileItWaits) {
  setParameter("frames/base", std::string("never_known"));
  load();
  for (const auto& cloud : toClouds(driveInRoom(2))) publish(cloud);
  ASSERT_TRUE(listener_.diagnoses("scans waiting", 1));
  EXPECT_TRUE(loader_.unload(space_ + "odometry"));
}

}  // namespace
}  // namespace revisit_slam
