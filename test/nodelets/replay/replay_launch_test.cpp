// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "support/child_process.h"
#include "support/odometry_listener.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

TEST(ReplayLaunch, mapsEveryScanOfABagWithParametersFromAFile) {
  const TemporaryFolder folder;
  const Drive drive = driveInRoom(20);
  writeScanBag(folder.file("drive.bag"), toClouds(drive), "/lidar/points");
  folder.with("room.yaml", "odometry:\n  max_range: 10.0\nlive:\n  diagnostics_period: 0.2\n");
  const OdometryListener listener;
  ChildProcess launch({"roslaunch", "revisit_slam", "replay.launch", "bag:=drive.bag",
                       "params:=room.yaml", "topic:=/lidar/points", "rate:=2", "base_frame:=none"},
                      folder.file(""));
  EXPECT_TRUE(listener.diagnoses("scans processed", 20)) << launch.output();
  EXPECT_EQ(listener.diagnosed("scans received"), 20);
  EXPECT_TRUE(listener.drops().empty());
  EXPECT_GT(listener.diagnosed("points dropped, too far"), 1000);

  bool sim_time = false;
  EXPECT_TRUE(ros::param::get("/use_sim_time", sim_time) && sim_time);
  std::string base_frame = "?";
  EXPECT_TRUE(ros::param::get("/odometry/frames/base", base_frame));
  EXPECT_EQ(base_frame, "");
}

/// What a file of parameters names is played, and looked at, too.
TEST(ReplayLaunch, topicsAndFramesOfAFileOfParametersAreThoseThatArePlayed) {
  const TemporaryFolder folder;
  const Drive drive = driveInRoom(20);
  writeScanBag(folder.file("drive.bag"), toClouds(drive), "/roof/points");
  folder.with("robot.yaml",
              "input: {topics: /roof/points}\nframes: {base: lidar}\n"
              "odometry: {max_range: 60.0}\nlive: {diagnostics_period: 0.2}\n");
  const OdometryListener listener;
  ChildProcess launch({"roslaunch", "revisit_slam", "replay.launch", "bag:=drive.bag",
                       "params:=robot.yaml", "rate:=2"},
                      folder.file(""));
  EXPECT_TRUE(listener.diagnoses("scans processed", 20)) << launch.output() << listener.message();
}

}  // namespace
}  // namespace revisit_slam
