// SPDX-License-Identifier: MIT
// What the machine does to a run: a disk that is full for a while, a folder that cannot be written,
// a process that is asked to end.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "revisit_slam/io/trajectory.h"
#include "support/contains.h"
#include "support/offline_program.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

class Faults : public testing::Test {
 protected:
  Faults() { writeScanBag(folder_.file("drive.bag"), toClouds(driveInRoom(300))); }

  /// As a shell starts it, after `before`.
  std::vector<std::string> offline(const std::string& before, const std::string& out) const {
    return {"bash", "-c",
            before + "exec " REVISIT_SLAM_OFFLINE_PROGRAM " --bag " + folder_.file("drive.bag") +
                " --out " + folder_.file(out) +
                " --set mapping/submap/displacement=2 --set mapping/submap/path_length=2"
                " --set mapping/local_map/displacement=4 --set mapping/local_map/path_length=4"};
  }

  static bool says(const ChildProcess& process, const std::string& text) {
    for (int i = 0; i < 3000 && !contains(process.output(), text); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return contains(process.output(), text);
  }

  TemporaryFolder folder_;
};

/// No file may grow beyond 64 kB, until all may again.
TEST_F(Faults, ADiskThatIsFullForAWhileCostsNothing) {
  ChildProcess undisturbed(offline("", "undisturbed"));
  ASSERT_EQ(undisturbed.wait(120.0), 0) << undisturbed.output();
  ChildProcess process(offline("trap '' XFSZ; ulimit -S -f 64; ", "disturbed"));
  ASSERT_TRUE(says(process, "File too large")) << process.output();
  rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  ASSERT_EQ(prlimit(process.id(), RLIMIT_FSIZE, &limit, nullptr), 0);
  ASSERT_EQ(process.wait(120.0), 0) << process.output();
  for (const char* name : {"odometry.tum", "trajectory.tum", "map.pcd", "map.bt", "pose_graph.g2o"})
    EXPECT_TRUE(textOf(folder_.file("disturbed/") + name) ==
                textOf(folder_.file("undisturbed/") + name))
        << name;
}

TEST_F(Faults, ADiskThatStaysFullLeavesAMessageWithTheReason) {
  ChildProcess process(offline("trap '' XFSZ; ulimit -f 64; ", "full"));
  EXPECT_EQ(process.wait(120.0), 1);
  EXPECT_TRUE(contains(process.output(), "File too large")) << process.output();
}

TEST_F(Faults, AFolderThatCannotBeMadeIsRefusedWithTheReason) {
  ChildProcess process({REVISIT_SLAM_OFFLINE_PROGRAM, "--bag", folder_.file("drive.bag"), "--out",
                        "/proc/nowhere/run"});
  EXPECT_EQ(process.wait(60.0), 1);
  EXPECT_TRUE(contains(process.output(), "/proc/nowhere")) << process.output();
  EXPECT_TRUE(contains(process.output(), "No such file or directory")) << process.output();
}

TEST_F(Faults, AskedToEndItLeavesItsMap) {
  ChildProcess process(offline("", "ended"));
  ASSERT_TRUE(says(process, "mapping"));
  for (int i = 0; i < 3000 && !std::filesystem::exists(folder_.file("ended/submaps/000001.rsm"));
       ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  process.signal(SIGTERM);
  ASSERT_EQ(process.wait(60.0), 128 + SIGTERM) << process.output();
  EXPECT_FALSE(readTum(folder_.file("ended/trajectory.tum")).empty());
  EXPECT_TRUE(std::filesystem::exists(folder_.file("ended/map.pcd")));
}

}  // namespace
}  // namespace revisit_slam
