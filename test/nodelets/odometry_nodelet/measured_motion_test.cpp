// SPDX-License-Identifier: MIT
// Motion that is measured outside, live.
#include <rosbag/bag.h>

#include "in_process_odometry.h"
#include "support/offline_program.h"

namespace revisit_slam {
namespace {

/// Wheels that count two per cent too much, at the ends of the sweeps and half-way.
std::vector<nav_msgs::Odometry> wheelsOf(const Drive& drive, const std::string& child_frame) {
  const Pose T_base_sensor = drive.scans[0].T_base_sensor;
  std::vector<nav_msgs::Odometry> messages;
  Pose T_world_sensor;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const Pose T_before_base =
        i == 0 ? Pose() : drive.T_first_base[i - 1].inverse() * drive.T_first_base[i];
    const Tangent moved = log(T_base_sensor.inverse() * T_before_base * T_base_sensor);
    for (const double seconds : {-0.05, 0.0}) {
      T_world_sensor = boxplus(T_world_sensor, 0.5 * 1.02 * moved);
      nav_msgs::Odometry message;
      message.header.stamp = toRosTime(drive.scans[i].stamp.plusSeconds(seconds));
      message.header.frame_id = "wheels";
      message.child_frame_id = child_frame;
      message.pose.pose = toPoseMessage(T_world_sensor);
      messages.push_back(message);
    }
  }
  return messages;
}

class MeasuredMotion : public InProcessOdometry {
 protected:
  MeasuredMotion() {
    setParameter("priors/odometry_topic", std::string("/wheels"));
    setParameter("live/transform_patience", 0.2);
  }

  const Drive drive_ = driveInRoom(25);
  const std::vector<sensor_msgs::PointCloud2> clouds_ = toClouds(drive_);
  ros::Publisher wheels_ = node_.advertise<nav_msgs::Odometry>("/wheels", 1000);
};

Trajectory mapOffline(const std::string& bag, const std::vector<std::string>& more) {
  std::vector<std::string> options{"--set", "frames/base=",
                                   "--set", "odometry/max_range=60",
                                   "--set", "odometry/map/voxel_size=0.5"};
  options.insert(options.end(), more.begin(), more.end());
  const OfflineProgram offline(bag, options);
  EXPECT_EQ(offline.status, 0) << offline.output;
  return readTum(offline.results("odometry.tum"));
}

TEST_F(MeasuredMotion, liveEqualsOfflineThoughMessagesComeInAnotherOrder) {
  const std::vector<nav_msgs::Odometry> wheels = wheelsOf(drive_, "lidar");
  const TemporaryFolder folder;
  {
    rosbag::Bag bag(folder.file("drive.bag"), rosbag::bagmode::Write);
    for (const auto& cloud : clouds_) bag.write("/points", cloud.header.stamp, cloud);
    for (const auto& message : wheels) bag.write("/wheels", message.header.stamp, message);
  }
  const Trajectory expected =
      mapOffline(folder.file("drive.bag"), {"--set", "priors/odometry_topic=/wheels"});
  const Trajectory without = mapOffline(folder.file("drive.bag"), {});
  ASSERT_EQ(expected.size(), clouds_.size());
  EXPECT_GT(
      (expected.back().T_world_base.translation - without.back().T_world_base.translation).norm(),
      1e-6);

  load();
  ASSERT_TRUE(becomesTrue([&] { return wheels_.getNumSubscribers() > 0; }));
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    publish(clouds_[i]);
    if (i < 2) continue;
    for (const std::size_t j : {2 * i - 4, 2 * i - 3}) wheels_.publish(wheels[j]);  // late by two
    ASSERT_TRUE(listener_.hasPoses(i - 1)) << i;  // scans further ahead would not wait for them
  }
  for (std::size_t j = wheels.size() - 4; j < wheels.size(); ++j) wheels_.publish(wheels[j]);
  ASSERT_TRUE(listener_.hasPoses(clouds_.size()));
  const Trajectory live = listener_.trajectory();
  for (std::size_t i = 0; i < live.size(); ++i) {
    const Pose &a = live[i].T_world_base, &b = expected[i].T_world_base;
    EXPECT_LT((a.translation - b.translation).norm(), 1e-6) << i;
    EXPECT_LT((a.inverse() * b).angle(), 1e-6) << i;
  }
  EXPECT_TRUE(listener_.diagnoses("odometry used in scans", 24));
}

TEST_F(MeasuredMotion, aFrameWithoutTransformCostsItsMessagesAndNoScan) {
  load();
  ASSERT_TRUE(becomesTrue([&] { return wheels_.getNumSubscribers() > 0; }));
  const std::vector<nav_msgs::Odometry> wheels = wheelsOf(drive_, "nowhere");
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    publish(clouds_[i]);
    wheels_.publish(wheels[2 * i]);
  }
  ASSERT_TRUE(listener_.hasPoses(clouds_.size()));
  EXPECT_TRUE(listener_.diagnoses("odometry messages dropped: no transform from 'nowhere'", 25));
  EXPECT_TRUE(listener_.drops().empty());
}

TEST_F(MeasuredMotion, aSensorThatStopsHoldsNothingUp) {
  load();
  ASSERT_TRUE(becomesTrue([&] { return wheels_.getNumSubscribers() > 0; }));
  const std::vector<nav_msgs::Odometry> wheels = wheelsOf(drive_, "lidar");
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    publish(clouds_[i]);
    for (const std::size_t j : {2 * i, 2 * i + 1})
      if (i < 8) wheels_.publish(wheels[j]);
  }
  ASSERT_TRUE(listener_.hasPoses(clouds_.size()));
  EXPECT_TRUE(listener_.diagnoses("odometry missing in scans", 17));
}

TEST_F(MeasuredMotion, itsOwnOdometryIsNoOther) {
  setParameter("priors/odometry_topic", std::string());
  setParameter("priors/odometry_frame", std::string("odom"));
  EXPECT_FALSE(loader_.load(space_ + "odometry", "revisit_slam/Odometry", {}, {}));
  setParameter("priors/odometry_frame", std::string("/odom"));
  EXPECT_FALSE(loader_.load(space_ + "odometry", "revisit_slam/Odometry", {}, {}));
  setParameter("live/broadcast_odom", false);
  setParameter("priors/odometry_frame", std::string());
  setParameter("priors/odometry_topic", std::string("odometry"));
  EXPECT_FALSE(loader_.load(space_ + "odometry", "revisit_slam/Odometry", {}, {}));
  setParameter("priors/odometry_topic", std::string());
  setParameter("priors/odometry_frame", std::string("odom"));
  load();
}

}  // namespace
}  // namespace revisit_slam
