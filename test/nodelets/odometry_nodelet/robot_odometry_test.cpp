// SPDX-License-Identifier: MIT
// The map frame against an odometry that the robot broadcasts itself.
#include <gtest/gtest.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/node/map_broadcaster.h"
#include "support/odometry_listener.h"

namespace revisit_slam {
namespace {

const Stamp kStart = Stamp::fromSeconds(1000.0);

/// Ours, and that of the robot, which has drifted away and begun elsewhere.
Pose ours(double seconds) {
  return {expSO3({0.0, 0.0, 0.1 * seconds}), {2.0 * seconds, 0.0, 0.1}};
}
Pose robots(double seconds) {
  return {expSO3({0.0, 0.0, 0.5 + 0.12 * seconds}), {5.0, 1.9 * seconds, 0.0}};
}

RegisteredScan scanAt(double seconds) {
  RegisteredScan scan;
  scan.stamp = kStart.plusSeconds(seconds);
  scan.T_odom_base = ours(seconds);
  return scan;
}

TEST(RobotOdometry, TheBaseIsInTheMapWhereTheSlamHasIt) {
  FramesConfig frames;
  frames.odom = "wheel_odom";
  frames.base = "robot";
  frames.map = "map_of_test";
  LiveConfig live;
  live.broadcast_odom = false;
  MapBroadcaster broadcaster(frames, live);
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer);
  tf2_ros::TransformBroadcaster robot;
  const Pose T_map_ours{expSO3({0.0, 0.0, -0.2}), {0.3, 0.4, 0.0}};
  broadcaster.onScan(scanAt(1.0));
  MapCorrection correction;
  correction.T_map_odom = T_map_ours;
  broadcaster.correct(correction);
  EXPECT_FALSE(buffer.canTransform("map_of_test", "robot", ros::Time(0)));  // not known yet

  const auto isPlaced = [&] {
    for (const double seconds : {0.95, 1.05}) {  // between them it is interpolated
      geometry_msgs::TransformStamped moved;
      moved.header.stamp = toRosTime(kStart.plusSeconds(seconds));
      moved.header.frame_id = "wheel_odom";
      moved.child_frame_id = "robot";
      moved.transform = toTransformMessage(robots(seconds));
      robot.sendTransform(moved);
    }
    broadcaster.broadcast();
    return buffer.canTransform("map_of_test", "wheel_odom", ros::Time(0));
  };
  ASSERT_TRUE(becomesTrue(isPlaced));
  const Pose T_map_robot =
      toPose(buffer.lookupTransform("map_of_test", "wheel_odom", ros::Time(0)).transform);
  const Pose error = (T_map_ours * ours(1.0)).inverse() * T_map_robot * robots(1.0);
  EXPECT_LT(error.translation.norm(), 0.01);
  EXPECT_LT(error.angle(), 1e-3);
}

}  // namespace
}  // namespace revisit_slam
