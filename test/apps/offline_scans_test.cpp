// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "revisit_slam/io/trajectory.h"
#include "support/contains.h"
#include "support/offline_program.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

std::vector<Stamp> stampsOf(const std::string& tum) {
  std::vector<Stamp> stamps;
  for (const StampedPose& pose : readTum(tum)) stamps.push_back(pose.stamp);
  return stamps;
}

TEST(OfflineScans, badScansAreReportedAndCountedAndNothingElseIsLost) {
  const Drive drive = driveInRoom(8);
  auto clouds = toClouds(drive);
  const BadClouds bad(clouds[4]);
  clouds.insert(clouds.begin() + 4, {bad.empty, bad.all_nan, bad.no_point_step, bad.truncated,
                                     bad.no_y, clouds[3], clouds[1]});
  const TemporaryFolder folder;
  writeScanBag(folder.file("drive.bag"), clouds);
  const OfflineProgram run(folder.file("drive.bag"));
  ASSERT_EQ(run.status, 0) << run.output;

  std::vector<Stamp> good_stamps;
  for (const Scan& scan : drive.scans) good_stamps.push_back(scan.stamp);
  EXPECT_EQ(stampsOf(run.results("odometry.tum")), good_stamps);

  const nlohmann::json scans = run.summary()["scans"];
  EXPECT_EQ(scans["received"], 15);
  EXPECT_EQ(scans["processed"], 8);
  EXPECT_EQ(scans["dropped"], nlohmann::json({{"bad layout", 2},
                                              {"duplicate stamp", 1},
                                              {"no finite points", 1},
                                              {"no points", 1},
                                              {"no x, y, z", 1},
                                              {"time went back", 1}}));
  for (const auto& [reason, count] : scans["dropped"].items())
    EXPECT_TRUE(contains(run.output, "dropped: " + reason));
}

TEST(OfflineScans, bagWithoutAnyGoodScanFails) {
  const TemporaryFolder folder;
  writeScanBag(folder.file("drive.bag"), {BadClouds(toCloud(driveInRoom(1).scans[0])).truncated});
  const OfflineProgram run(folder.file("drive.bag"));
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.output, "not one of 1 scans could be processed"));
}

TEST(OfflineScans, resultsAreTheSameBytesFromRunToRunAndForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const std::string bag = folder.file("drive.bag");
  writeScanBag(bag, toClouds(driveInRoom(30)));
  const auto run = [&bag](const std::string& threads) {
    const OfflineProgram program(bag, {"--threads", threads});
    EXPECT_EQ(program.status, 0) << program.output;
    return textOf(program.results("odometry.tum")) + textOf(program.results("map.pcd"));
  };
  const std::string one_thread = run("1"), two_threads = run("2"), again = run("2");
  EXPECT_GT(one_thread.size(), 1000u);
  EXPECT_TRUE(one_thread == two_threads);
  EXPECT_TRUE(two_threads == again);
}

TEST(OfflineScans, noMoreScansThanAskedForAreRead) {
  const TemporaryFolder folder;
  writeScanBag(folder.file("drive.bag"), toClouds(driveInRoom(5)));
  const OfflineProgram run(folder.file("drive.bag"), {"--max-scans", "3"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(stampsOf(run.results("odometry.tum")).size(), 3u);
}

}  // namespace
}  // namespace revisit_slam
