// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>

#include "revisit_slam/ros/node/stage_topics.h"
#include "support/contains.h"
#include "support/odometry_listener.h"
#include "support/ros_log.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

TEST(RemoteSubscriber, isToldThatRegisteredScansDoNotLeaveTheManagerWhichLivesOn) {
  const RosLog log;
  ros::NodeHandle node;
  std::atomic<int> scans_got{0};
  const auto count = [&](const boost::shared_ptr<const OdometryOutput>&) { ++scans_got; };
  const auto remote = node.subscribe<OdometryOutput>("registered_scan", 10, count);
  const auto points = node.advertise<sensor_msgs::PointCloud2>("points", 100);
  const OdometryListener listener;
  ASSERT_TRUE(becomesTrue([&] { return listener.isConnected() && remote.getNumPublishers() > 0; }));
  ASSERT_TRUE(becomesTrue([&] { return points.getNumSubscribers() > 0; }));

  const auto clouds = toClouds(driveInRoom(5));
  for (const auto& cloud : clouds) points.publish(cloud);
  const auto is_told = [&] {
    return log.text().find("RegisteredScan does not leave the nodelet manager") !=
           std::string::npos;
  };
  EXPECT_TRUE(becomesTrue(is_told)) << log.text();
  EXPECT_TRUE(listener.hasPoses(5));
  EXPECT_TRUE(listener.diagnoses("scans processed", 5));
  EXPECT_EQ(scans_got, 0);
}

}  // namespace
}  // namespace revisit_slam
