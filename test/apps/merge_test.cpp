// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/session/session_reader.h"
#include "support/contains.h"
#include "support/offline_program.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

/// Drives through one room, each mapped in a program of its own.
class MergeTest : public testing::Test {
 protected:
  MergeTest() {
    writeScanBag(folder_.file("drive.bag"), toClouds(driveInRoom(120)));
    for (const char* name : {"a", "b"})
      run({REVISIT_SLAM_OFFLINE_PROGRAM, "--bag", folder_.file("drive.bag"), "--out",
           folder_.file(name), "--quiet"},
          0);
  }

  std::string run(const std::vector<std::string>& arguments, int expected_status) const {
    ChildProcess process(arguments);
    EXPECT_EQ(process.wait(300.0), expected_status) << process.output();
    return process.output();
  }
  std::string merge(const std::vector<std::string>& options, int expected_status) const {
    std::vector<std::string> arguments{REVISIT_SLAM_MERGE_PROGRAM, folder_.file("a"),
                                       folder_.file("b")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments, expected_status);
  }

  TemporaryFolder folder_;
};

/// A room is one local map, so that one place has to do.
TEST_F(MergeTest, TheResultIsASessionWithAllFilesOfBoth) {
  const std::string said =
      merge({"--out", folder_.file("both"), "--set", "loops/joining/min_places=1"}, 0);
  EXPECT_TRUE(contains(said, "local map 0 of " + folder_.file("b") + " shows the place of"));
  std::vector<std::string> notices;
  const Session session = readSession(folder_.file("both"), notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  EXPECT_TRUE(session.info.closed);
  EXPECT_EQ(sessionsOf(session).size(), 2u);
  for (const char* name : {"map.pcd", "map.bt", "pose_graph.g2o", "loop_closures.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder_.file("both/") + name)) << name;
  const Trajectory a = readTum(folder_.file("both/trajectory_0.tum")),
                   b = readTum(folder_.file("both/trajectory_1.tum"));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_LT((a[i].T_world_base.translation - b[i].T_world_base.translation).norm(), 0.05) << i;
}

TEST_F(MergeTest, ADriveExtendsAMap) {
  const auto extend = [&](const std::string& out, const std::string& places) {
    return run({REVISIT_SLAM_OFFLINE_PROGRAM, "--bag", folder_.file("drive.bag"), "--map",
                folder_.file("a"), "--mode", "extend", "--out", folder_.file(out), "--set",
                "loops/joining/min_places=" + places},
               0);
  };
  EXPECT_TRUE(contains(extend("larger", "1"), "the drive is in the map that it extends"));
  std::vector<std::string> notices;
  const Session session = readSession(folder_.file("larger"), notices);
  EXPECT_TRUE(notices.empty()) << notices.front();
  EXPECT_EQ(sessionsOf(session), (std::vector<SessionId>{SessionId{0}, SessionId{1}}));
  EXPECT_EQ(textOf(folder_.file("larger/submaps/000000.rsm")),
            textOf(folder_.file("a/submaps/000000.rsm")));
  EXPECT_TRUE(contains(extend("apart", "2"), "session 1 is left out"));
}

TEST_F(MergeTest, WhatCannotBeJoinedIsNamedAndNothingIsWritten) {
  const std::string said = merge({"--out", folder_.file("both")}, 2);
  EXPECT_TRUE(contains(said, folder_.file("b") + " is left out"));
  EXPECT_TRUE(contains(said, "nothing was written"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("both")));
}

TEST_F(MergeTest, NothingIsOverwrittenAndNothingElseIsRead) {
  EXPECT_TRUE(contains(merge({"--out", folder_.file("a")}, 1), "holds results already"));
  std::filesystem::remove(folder_.file("b/submaps/000000.rsm"));
  EXPECT_TRUE(contains(merge({"--out", folder_.file("both")}, 1), "b' cannot be used"));
  std::filesystem::remove(folder_.file("b/session.yaml"));
  EXPECT_TRUE(contains(merge({"--out", folder_.file("both")}, 1), "is no session"));
}

TEST_F(MergeTest, ASessionIsRefusedTheSecondTime) {
  const std::string said = merge({folder_.file("b/../a"), "--out", folder_.file("both")}, 1);
  EXPECT_TRUE(contains(said, "a' is given twice")) << said;
  EXPECT_FALSE(std::filesystem::exists(folder_.file("both")));
}

}  // namespace
}  // namespace revisit_slam
