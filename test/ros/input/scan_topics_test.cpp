// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_topics.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

const TypedTopic kPoints{"/points", "sensor_msgs/PointCloud2"};
const TypedTopic kOuster{"/os/points", "sensor_msgs/PointCloud2"};
const TypedTopic kLivox{"/livox/lidar", "livox_ros_driver2/CustomMsg"};
const TypedTopic kLaser{"/scan", "sensor_msgs/LaserScan"};

TEST(ScanTopics, AreThoseOfTheDriversAndNotOurOwn) {
  const auto found = scanTopics({kOuster,
                                 {"/map_cloud", "sensor_msgs/PointCloud2"},
                                 kLaser,
                                 kLivox,
                                 {"/robot/submaps", "sensor_msgs/PointCloud2"}});
  EXPECT_EQ(namesOf(found), "/livox/lidar, /os/points");
  EXPECT_EQ(namesOf({}), "none");
}

TEST(ScanTopics, AreGivenToTheArgumentForTheirType) {
  EXPECT_EQ(argumentFor(kOuster), "points:=/os/points");
  EXPECT_EQ(argumentFor(kLivox), "livox_points:=/livox/lidar");
}

TEST(Silence, OfATopicThatNobodyPublishesNamesTheOthers) {
  EXPECT_EQ(
      describeSilence({"/points"}, {kOuster, kLivox}),
      "nobody publishes /points: start with livox_points:=/livox/lidar or points:=/os/points");
  EXPECT_EQ(
      describeSilence({"/points", "/livox"}, {}),
      "nobody publishes /points or /livox: no topic with scans is published: start the driver");
}

TEST(Silence, OfATopicOfAnotherTypeNamesTheType) {
  EXPECT_EQ(describeSilence({"/scan"}, {kLaser, kPoints}),
            "/scan is of type sensor_msgs/LaserScan, not of scans: start with points:=/points");
  EXPECT_EQ(describeSilence({"/livox/lidar"}, {kLivox}),
            "/livox/lidar is of type livox_ros_driver2/CustomMsg: start with "
            "livox_points:=/livox/lidar");
}

TEST(Silence, OfAPublisherPointsAtTheSensor) {
  EXPECT_EQ(describeSilence({"/points"}, {kPoints}),
            "/points has a publisher that sends nothing: check the sensor and its driver, with: "
            "rostopic hz /points");
}

}  // namespace
}  // namespace revisit_slam
