// SPDX-License-Identifier: MIT
#include <tf2_ros/static_transform_broadcaster.h>

#include <chrono>

#include "in_process_odometry.h"

namespace revisit_slam {
namespace {

using FullQueue = InProcessOdometry;

TEST_F(FullQueue, everyScanThatFindsNoRoomIsCounted) {
  setParameter("frames/base", std::string("slow_robot"));  // the first scan holds the others up
  setParameter("live/queue_size", 1);
  load();
  const Drive drive = driveInRoom(30);
  for (const auto& cloud : toClouds(drive)) publish(cloud);
  // One in work, one waiting; whether the first was taken out in time is the system's business.
  ASSERT_TRUE(becomesTrue([this] { return listener_.diagnosed("scans received") >= 28; }));

  EXPECT_TRUE(becomesTrue(  // as it waits for the transform
      [this] { return listener_.diagnosed("busy with odometry (%)") >= 90; }));

  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped mounting;
  mounting.header.frame_id = "slow_robot";
  mounting.child_frame_id = "lidar";
  mounting.transform.rotation.w = 1.0;
  broadcaster.sendTransform(mounting);
  ASSERT_TRUE(listener_.diagnoses("scans received", 30));
  // The last one has a gap before it, and no scan after it: it goes on when none has come for a
  // while.
  EXPECT_TRUE(becomesTrue([this] {
    return listener_.diagnosed("scans processed") + listener_.drops()["queue full"] == 30;
  }));
  EXPECT_TRUE(becomesTrue([this] { return listener_.diagnosed("busy with odometry (%)") <= 10; }));
  EXPECT_TRUE(becomesTrue([this] {  // that of this test
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    while (std::chrono::steady_clock::now() < end) continue;
    return listener_.diagnosed("CPU of the process (%)") > 0;
  }));
  const int processed = listener_.diagnosed("scans processed");
  EXPECT_GE(processed, 1);
  EXPECT_LE(processed, 2);
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"queue full", 30 - processed}}));
  EXPECT_EQ(listener_.stamps().back(), drive.scans.back().stamp);
}

}  // namespace
}  // namespace revisit_slam
