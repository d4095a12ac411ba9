// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include "revisit_slam/io/trajectory.h"
#include "support/contains.h"
#include "support/offline_program.h"
#include "support/raw_messages.h"
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

TEST(OfflineScans, damagedMessagesInABagCostThemselvesAlone) {
  const Drive drive = driveInRoom(8);
  const auto clouds = toClouds(drive);
  auto cut = bytesOf(clouds[4]);
  cut.resize(cut.size() / 3);
  const std::vector<std::uint8_t> headless(3, 0xff);
  auto announces_more = bytesOf(tf2_msgs::TFMessage());
  announces_more.assign(announces_more.size(), 0xff);
  const TemporaryFolder folder;
  rosbag::Bag bag(folder.file("drive.bag"), rosbag::bagmode::Write);
  ros::Time received(1.0);
  const auto record = [&](const auto& message, const std::string& topic = "/points") {
    bag.write(topic, received += ros::Duration(0.1), message);
  };
  record(claiming<tf2_msgs::TFMessage>(announces_more), "/tf_static");
  record(claiming<sensor_msgs::PointCloud2>(headless));
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    if (i == 3) record(claiming<sensor_msgs::PointCloud2>(bytesThatAnnounceMore(clouds[i])));
    if (i == 4) record(claiming<sensor_msgs::PointCloud2>(cut));
    record(clouds[i]);
  }
  bag.close();
  const OfflineProgram run(folder.file("drive.bag"));
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(contains(run.output, "1 messages with transforms are damaged"));
  EXPECT_EQ(stampsOf(run.results("trajectory.tum")).size(), 8u);
  EXPECT_EQ(run.summary()["scans"]["dropped"], nlohmann::json({{"bad layout", 3}}));
  EXPECT_LT(run.summary()["peak_memory_mb"], 1000.0);  // nothing was taken for what was announced
}

TEST(OfflineScans, aDamagedPieceOfABagCostsItsScansAlone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("drive.bag");
  const auto clouds = toClouds(driveInRoom(8));
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::BZ2);
  bag.setChunkThreshold(1);  // a piece for each scan
  for (const auto& cloud : clouds) bag.write("/points", cloud.header.stamp, cloud);
  bag.close();
  std::string bytes = textOf(path);
  std::size_t block = 0;
  for (int i = 0; i < 4; ++i) block = bytes.find("BZh", block + 1);
  ASSERT_NE(block, std::string::npos);
  for (std::size_t i = 40; i < 60; ++i) bytes[block + i] = 'x';
  const OfflineProgram run(folder.with("damaged.bag", bytes));
  ASSERT_EQ(run.status, 0) << run.output;
  const nlohmann::json scans = run.summary()["scans"];
  EXPECT_EQ(scans["received"], 8);
  EXPECT_EQ(scans["processed"], 7);
  EXPECT_EQ(scans["dropped"], nlohmann::json({{"unreadable", 1}})) << run.output;
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
