// SPDX-License-Identifier: MIT
// What a beginner gets wrong: the diagnostics say what it is, and following them helps.
#include <diagnostic_msgs/DiagnosticStatus.h>
#include <std_msgs/Bool.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include "in_process_odometry.h"
#include "support/contains.h"
#include "support/ros_log.h"

namespace revisit_slam {
namespace {

using InputFaults = InProcessOdometry;
using Status = diagnostic_msgs::DiagnosticStatus;

TEST_F(InputFaults, aTopicThatNobodyPublishesIsSaidWithThoseThatThereAre) {
  const RosLog log;
  const ros::Publisher driver =
      node_.advertise<sensor_msgs::PointCloud2>("/faults/driver_points", 10);
  points_.shutdown();
  ASSERT_TRUE(loader_.load(space_ + "odometry", "revisit_slam/Odometry", {}, {}));
  EXPECT_TRUE(listener_.judges(Status::WARN, "nobody publishes " + space_ + "points"))
      << listener_.message();
  EXPECT_TRUE(contains(listener_.message(), "points:=/faults/driver_points"));
  EXPECT_TRUE(contains(log.text(), "points:=/faults/driver_points"));
}

TEST_F(InputFaults, aDriverThatStopsIsSaid) {
  load();
  const auto clouds = toClouds(driveInRoom(8));
  for (const auto& cloud : clouds) {
    publish(cloud);
    ros::WallDuration(0.1).sleep();
  }
  EXPECT_TRUE(listener_.judges(Status::OK, " scans/s on " + space_ + "points"))
      << listener_.message();
  EXPECT_TRUE(listener_.judges(Status::WARN, "no scan for ")) << listener_.message();
}

TEST_F(InputFaults, aMissingTransformIsAnErrorThatNamesBothWaysOut) {
  setParameter("frames/base", std::string("robot"));
  load();
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped mounting;
  mounting.transform.rotation.w = 1.0;
  mounting.header.frame_id = "mast";
  mounting.child_frame_id = "lidar";
  broadcaster.sendTransform(mounting);
  for (const auto& cloud : toClouds(driveInRoom(5))) publish(cloud);
  EXPECT_TRUE(listener_.judges(Status::ERROR, "5 scans wait")) << listener_.message();
  for (const char* remedy : {"static_transform_publisher 0 0 0 0 0 0 robot lidar",
                             "base_frame:=none", "connected with: mast"})
    EXPECT_TRUE(contains(listener_.message(), remedy)) << listener_.message();
  geometry_msgs::TransformStamped mast = mounting;
  mast.header.frame_id = "robot";
  mast.child_frame_id = "mast";
  broadcaster.sendTransform(std::vector<geometry_msgs::TransformStamped>{mounting, mast});
  EXPECT_TRUE(listener_.hasPoses(5));
}

TEST_F(InputFaults, aBaseThatTfPlacesAlreadyIsAnErrorThatNamesBothWaysOut) {
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped mounting;
  mounting.transform.rotation.w = 1.0;
  mounting.header.frame_id = "vehicle";
  mounting.child_frame_id = "lidar";
  broadcaster.sendTransform(mounting);
  tf2_ros::Buffer known;
  tf2_ros::TransformListener listener(known);
  ASSERT_TRUE(becomesTrue([&] { return known.canTransform("vehicle", "lidar", ros::Time(0)); }));
  load();                                         // the base is the sensor
  ASSERT_TRUE(listener_.judges(Status::OK, ""));  // it listens, too
  for (const auto& cloud : toClouds(driveInRoom(3))) publish(cloud);
  EXPECT_TRUE(listener_.judges(Status::ERROR, "TF places 'lidar' in 'vehicle' already"))
      << listener_.message();
  for (const char* remedy : {"broadcast_odom:=false", "base_frame:="})
    EXPECT_TRUE(contains(listener_.message(), remedy)) << listener_.message();
  EXPECT_TRUE(listener_.hasPoses(3));
}

TEST_F(InputFaults, zeroStampsAreAnErrorAndArrivalsAreUsedOnRequest) {
  auto clouds = toClouds(driveInRoom(6));
  for (auto& cloud : clouds) cloud.header.stamp = ros::Time();
  load();
  for (const auto& cloud : clouds) publish(cloud);
  EXPECT_TRUE(listener_.judges(Status::ERROR, "set input/stamps to arrival"))
      << listener_.message();
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"no stamp", 6}}));
  loader_.clear();
  setParameter("input/stamps", std::string("arrival"));
  load();
  for (const auto& cloud : clouds) {
    publish(cloud);
    ros::WallDuration(0.1).sleep();
  }
  EXPECT_TRUE(listener_.hasPoses(5));
}

TEST_F(InputFaults, aFieldThatTheMessagesDoNotHaveIsAnError) {
  setParameter("input/time_field", std::string("tiem"));
  load();
  for (const auto& cloud : toClouds(driveInRoom(3))) publish(cloud);
  EXPECT_TRUE(listener_.judges(Status::ERROR, "set input/time_field to auto"))
      << listener_.message();
}

TEST_F(InputFaults, scansWithoutTimesAreAWarningThatASettingEnds) {
  std::vector<sensor_msgs::PointCloud2> clouds = toClouds(driveInRoom(3));
  for (auto& cloud : clouds) cloud.fields.back().name = "intensity";
  load();
  for (const auto& cloud : clouds) publish(cloud);
  EXPECT_TRUE(listener_.judges(Status::WARN, "set input/time_field to azimuth"))
      << listener_.message();
  loader_.clear();
  setParameter("input/time_field", std::string("none"));
  load();
  for (const auto& cloud : clouds) publish(cloud);
  EXPECT_TRUE(listener_.judges(Status::OK, " scans/s on ")) << listener_.message();
}

}  // namespace
}  // namespace revisit_slam
