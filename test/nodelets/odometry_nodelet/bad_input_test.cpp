// SPDX-License-Identifier: MIT
#include <std_msgs/Bool.h>

#include <limits>

#include "in_process_odometry.h"
#include "revisit_slam/util/process_usage.h"
#include "support/raw_messages.h"

namespace revisit_slam {
namespace {

using BadInput = InProcessOdometry;

TEST_F(BadInput, badCloudsAreCountedByReasonAndGoodOnesAroundThemRegistered) {
  load();
  const Drive drive = driveInRoom(4);
  const auto clouds = toClouds(drive);
  const BadClouds bad(clouds[2]);
  for (const auto& cloud :
       {clouds[0], clouds[1], bad.empty, bad.all_nan, bad.no_point_step, bad.truncated, bad.no_y,
        clouds[0], clouds[1], toCloud(drive.scans[2], true), clouds[3]})
    publish(cloud);
  ASSERT_TRUE(listener_.diagnoses("scans received", 11));
  EXPECT_EQ(listener_.diagnosed("scans processed"), 4);
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"bad layout", 2},
                                                           {"duplicate stamp", 1},
                                                           {"no finite points", 1},
                                                           {"no points", 1},
                                                           {"no x, y, z", 1},
                                                           {"time went back", 1}}));
  EXPECT_TRUE(listener_.diagnosesEndingWith("time of a scan: median, p99, largest (ms)", " of 4"));
  ASSERT_TRUE(listener_.hasPoses(4));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(listener_.stamps()[i], drive.scans[i].stamp);
}

TEST_F(BadInput, bigEndianCloudsGiveTheSamePose) {
  load();
  const Drive drive = driveInRoom(6);
  for (const Scan& scan : drive.scans) publish(toCloud(scan, false));
  ASSERT_TRUE(listener_.hasPoses(6));
  loader_.clear();
  load();
  for (const Scan& scan : drive.scans) publish(toCloud(scan, true));
  ASSERT_TRUE(listener_.hasPoses(12));
  const Trajectory poses = listener_.trajectory();
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(distanceBetween(poses[i].T_world_base, poses[i + 6].T_world_base), 0.0);
}

TEST_F(BadInput, aMessageOfAnotherTypeIsCountedAndTheNodeletLivesOn) {
  setParameter("frames/base", std::string("robot"));  // where the sensor is on it is not known
  setParameter("live/transform_patience", 0.0);
  load();
  ros::Publisher wrong = node_.advertise<std_msgs::Bool>("livox_points", 10);
  ASSERT_TRUE(becomesTrue([&] { return wrong.getNumSubscribers() > 0; }));
  wrong.publish(std_msgs::Bool());
  ASSERT_TRUE(listener_.diagnoses("scans received", 1));
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"unsupported message type", 1}}));
  for (const auto& cloud : toClouds(driveInRoom(2))) publish(cloud);
  EXPECT_TRUE(listener_.diagnoses("scans received", 3));
  EXPECT_TRUE(listener_.diagnoses("errors", 0));
}

TEST_F(BadInput, aCloudThatAnnouncesMoreThanItHasIsCountedBeforeMemoryIsTaken) {
  load();
  const auto clouds = toClouds(driveInRoom(3));
  ros::NodeHandle node(space_);
  const auto hostile = claiming<sensor_msgs::PointCloud2>(bytesThatAnnounceMore(clouds[1]));
  ros::Publisher publisher = hostile.advertise(node, "points", 10);
  ASSERT_TRUE(becomesTrue([&] { return publisher.getNumSubscribers() > 0; }));
  publish(clouds[0]);
  ASSERT_TRUE(listener_.hasPoses(1));
  const double peak = peakMemoryMegabytes();
  publisher.publish(hostile);
  ASSERT_TRUE(listener_.diagnoses("scans received", 2));
  EXPECT_LT(peakMemoryMegabytes() - peak, 500.0);
  EXPECT_EQ(listener_.drops(), (std::map<std::string, int>{{"bad layout", 1}}));
  publish(clouds[2]);
  EXPECT_TRUE(listener_.diagnoses("scans received", 3));
}

TEST_F(BadInput, aClockSetBackBeginsANewSession) {
  load();
  const Drive drive = driveInRoom(12);
  auto clouds = toClouds(drive);
  for (std::size_t i = 0; i < 6; ++i) clouds[i].header.stamp += ros::Duration(100.0);
  for (const auto& cloud : clouds) publish(cloud);
  ASSERT_TRUE(listener_.hasPoses(12));
  EXPECT_EQ(listener_.trajectory()[6].T_world_base.translation.norm(), 0.0);
  EXPECT_TRUE(listener_.drops().empty());
}

TEST_F(BadInput, stampsAtTheEndOfTimeAreSurvived) {
  load();
  const auto clouds = toClouds(driveInRoom(2));
  auto far = clouds[1];
  far.header.stamp.sec = std::numeric_limits<std::uint32_t>::max();
  auto zero = clouds[0];
  zero.header.stamp = ros::Time();
  for (const auto& cloud : {zero, clouds[0], far, far}) publish(cloud);
  ASSERT_TRUE(listener_.diagnoses("scans received", 4));
  EXPECT_EQ(listener_.drops(),
            (std::map<std::string, int>{{"duplicate stamp", 1}, {"no stamp", 1}}));
}

}  // namespace
}  // namespace revisit_slam
