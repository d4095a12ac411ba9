// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/session/session_reader.h"
#include "support/contains.h"
#include "support/offline_program.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

/// A drive of many short submaps, mapped in a program of its own.
class SessionsTest : public testing::Test {
 protected:
  SessionsTest() { writeScanBag(folder_.file("drive.bag"), toClouds(driveInRoom(300))); }

  std::vector<std::string> offline(const std::string& out) const {
    return {REVISIT_SLAM_OFFLINE_PROGRAM,
            "--bag",
            folder_.file("drive.bag"),
            "--out",
            folder_.file(out),
            "--set",
            "mapping/submap/displacement=2",
            "--set",
            "mapping/submap/path_length=2"};
  }

  bool comesToExist(const std::string& name) const {
    for (int i = 0; i < 3000 && !std::filesystem::exists(folder_.file(name)); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return std::filesystem::exists(folder_.file(name));
  }

  std::string run(const std::vector<std::string>& arguments, int expected_status) const {
    ChildProcess process(arguments);
    EXPECT_EQ(process.wait(300.0), expected_status) << process.output();
    return process.output();
  }

  TemporaryFolder folder_;
};

TEST_F(SessionsTest, whatIsLeftOfAKilledRunIsAMap) {
  {
    ChildProcess process(offline("killed"));
    ASSERT_TRUE(comesToExist("killed/submaps/000002.rsm")) << process.output();
    process.signal(SIGKILL);
    EXPECT_EQ(process.wait(30.0), 128 + SIGKILL);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.file("killed/map.pcd")));
  const std::string said =
      run({REVISIT_SLAM_EXPORT_PROGRAM, folder_.file("killed"), "--format", "pcd,ply"}, 0);
  EXPECT_TRUE(contains(said, "not closed"));
  std::vector<std::string> notices;
  const Session session = readSession(folder_.file("killed"), notices);
  ASSERT_GE(session.submaps.size(), 2u);
  EXPECT_EQ(readTum(folder_.file("killed/trajectory.tum")).size(),
            session.submaps.back().last_scan.value + 1u);
  for (const char* name : {"map.pcd", "map.ply", "map.bt", "map.pgm", "submaps/000001.pcd"})
    EXPECT_TRUE(std::filesystem::exists(folder_.file("killed/") + name)) << name;
}

TEST_F(SessionsTest, anInterruptedRunEndsWithItsMap) {
  ChildProcess process(offline("interrupted"));
  ASSERT_TRUE(comesToExist("interrupted/submaps/000001.rsm")) << process.output();
  process.interrupt();
  ASSERT_EQ(process.wait(60.0), 128 + SIGINT) << process.output();
  const auto run = nlohmann::json::parse(textOf(folder_.file("interrupted/run.json")));
  EXPECT_EQ(run["interrupted"], true);
  const auto& scans = run["scans"];
  EXPECT_EQ(readTum(folder_.file("interrupted/trajectory.tum")).size(),
            scans["processed"].get<std::size_t>() - scans["at_rest"].get<std::size_t>());
  EXPECT_TRUE(std::filesystem::exists(folder_.file("interrupted/map.pcd")));
}

TEST_F(SessionsTest, exportMakesTheFilesOfTheRunAndTouchesNothingElse) {
  run(offline("run"), 0);
  EXPECT_TRUE(contains(run(offline("run"), 1), "not overwritten"));
  run({REVISIT_SLAM_EXPORT_PROGRAM, folder_.file("run"), "--out", folder_.file("out")}, 0);
  for (const char* name :
       {"trajectory.tum", "trajectory_kitti.txt", "pose_graph.g2o", "loop_closures.csv", "map.pcd",
        "map.bt", "map.pgm", "map.yaml", "submaps/submaps.csv", "submaps/000000.pcd"})
    EXPECT_EQ(textOf(folder_.file("run/") + name), textOf(folder_.file("out/") + name)) << name;
  EXPECT_TRUE(contains(
      run({REVISIT_SLAM_EXPORT_PROGRAM, folder_.file("run"), "--out", folder_.file("out")}, 1),
      "not overwritten"));
  EXPECT_TRUE(contains(run({REVISIT_SLAM_EXPORT_PROGRAM, folder_.file(".")}, 1), "no session"));
  EXPECT_TRUE(contains(
      run({REVISIT_SLAM_EXPORT_PROGRAM, folder_.file("run"), "--format", "laz"}, 1), "laszip"));
}

}  // namespace
}  // namespace revisit_slam
