// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <std_srvs/Trigger.h>

#include <cstdlib>

#include "support/odometry_listener.h"
#include "support/offline_program.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

/// Positions in the files have nine decimals, rotations twelve.
void expectSame(const StampedPose& live, const StampedPose& offline) {
  EXPECT_EQ(live.stamp.nanoseconds, offline.stamp.nanoseconds);
  const Pose& a = live.T_world_base;
  const Pose& b = offline.T_world_base;
  EXPECT_LT((a.translation - b.translation).norm(), 1e-6);
  EXPECT_LT((a.inverse() * b).angle(), 1e-6);
}

/// Plays the bag until `count` scans are registered.
void playAndCompare(const std::string& bag, const std::string& topic, std::size_t count,
                    const std::string& rate) {
  const OfflineProgram offline(
      bag, {"--topic", topic, "--max-scans", std::to_string(count), "--set", "frames/base="});
  ASSERT_EQ(offline.status, 0) << offline.output;
  const Trajectory expected = readTum(offline.results("odometry.tum"));
  ASSERT_EQ(expected.size(), count);

  const OdometryListener listener;
  ASSERT_TRUE(becomesTrue([&] { return listener.isConnected(); })) << "no odometry nodelet";
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("/odometry/reset", reset));
  {
    // A player that ends of itself may take the end of the last, large message with it.
    ChildProcess player({"rosbag", "play", "--quiet", "--keep-alive", "--wait-for-subscribers",
                         "--rate", rate, bag, "--topics", topic, topic + ":=/points"});
    ASSERT_TRUE(listener.hasPoses(count)) << listener.trajectory().size() << " poses\n"
                                          << player.output();
  }
  const Trajectory live = listener.trajectory();
  for (std::size_t i = 0; i < count; ++i) expectSame(live[i], expected[i]);
  const auto all_told = [&] {
    return listener.diagnosed("scans received") >= static_cast<int>(count);
  };
  EXPECT_TRUE(becomesTrue(all_told));
  EXPECT_TRUE(listener.drops().empty()) << listener.drops().begin()->first;
}

TEST(LiveEqualsOffline, onASimulatedDrive) {
  const TemporaryFolder folder;
  writeScanBag(folder.file("drive.bag"), toClouds(driveInRoom(30)), "/lidar/points");
  playAndCompare(folder.file("drive.bag"), "/lidar/points", 30, "2");
}

TEST(LiveEqualsOffline, onARecordedDrive) {
  const char* data = std::getenv("REVISIT_SLAM_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "REVISIT_SLAM_TEST_DATA is not set";
  playAndCompare(std::string(data) + "/kitti_raw_0001/kitti_raw_0001.bag", "/velodyne_points", 108,
                 "1");
}

}  // namespace
}  // namespace revisit_slam
