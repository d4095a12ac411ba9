// SPDX-License-Identifier: MIT
#include "revisit_slam/session/drive_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "session/logged_drive.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(DriveLog, PosesCanBeReadWhileTheRunIsOpen) {
  const TemporaryFolder folder;
  DriveLog log(folder.file(""));
  for (std::uint32_t i = 0; i < 3; ++i) {
    log.add(entryOf(scanAt(i), timesOf(i)));
    const Trajectory read = readTum(folder.file("odometry.tum"));
    ASSERT_EQ(read.size(), i + 1);
    EXPECT_EQ(read.back().stamp, scanAt(i).scan->stamp);
    EXPECT_EQ(read.back().T_world_base.translation, scanAt(i).scan->T_odom_base.translation);
  }
}

TEST(DriveLog, ScanTimesHaveAColumnForEachStageAndTheirSum) {
  const TemporaryFolder folder;
  {
    DriveLog log(folder.file(""));
    for (std::uint32_t i = 0; i < 2; ++i) log.add(entryOf(scanAt(i), timesOf(i)));
  }
  EXPECT_EQ(textOf(folder.file("scan_times.csv")),
            "scan,stamp,register_ms,downsample_ms,total_ms\n"
            "0,1700000000.000000001,1,0.5,1.5\n"
            "1,1700000000.100000001,2,0.5,2.5\n");
}

/// One that waited for the readings of an IMU, say, was read before.
TEST(DriveLog, ScanTimesHaveTheSameColumnsWhereAStageIsLeftOut) {
  const TemporaryFolder folder;
  {
    DriveLog log(folder.file(""));
    log.add(entryOf(scanAt(0), timesOf(0)));
    log.add(entryOf(scanAt(1), {{"downsample", 0.5}}));
    log.add(entryOf(scanAt(2), {{"read", 4.0}, {"register", 1.0}, {"downsample", 0.5}}));
  }
  EXPECT_EQ(textOf(folder.file("scan_times.csv")),
            "scan,stamp,register_ms,downsample_ms,total_ms\n"
            "0,1700000000.000000001,1,0.5,1.5\n"
            "1,1700000000.100000001,0,0.5,0.5\n"
            "2,1700000000.200000001,1,0.5,5.5\n");
}

TEST(DriveLog, InformationHasTheUpperTrianglesOfBothMatrices) {
  const TemporaryFolder folder;
  InformedScan informed = scanAt(0);
  std::string expected = "0,1700000000.000000001,identity,0.25,0";
  for (int i = 0; i < 36; ++i) {
    informed.estimate.information(i / 6, i % 6) = i;
    informed.covariance_motion(i / 6, i % 6) = 100 + i;
  }
  informed.estimate.mean_squared_residual = 0.25;
  for (const int first : {0, 100})
    for (int i = 0; i < 36; ++i)
      if (i % 6 >= i / 6) expected += "," + std::to_string(first + i);
  expected += ",good,0,0";
  DriveLog(folder.file("")).add(entryOf(informed, timesOf(0)));
  std::istringstream lines(textOf(folder.file("odometry_information.csv")));
  std::string header, line;
  ASSERT_TRUE(std::getline(lines, header) && std::getline(lines, line));
  EXPECT_EQ(header.find("scan,stamp,source,mean_squared_residual,weak_directions,information11,"
                        "information12"),
            0u);
  EXPECT_NE(header.find(",information66,covariance11,"), std::string::npos);
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 4 + 2 * 21 + 3);
  EXPECT_EQ(line, expected);
}

TEST(DriveLog, PairsOfSubmapsSayWhichGateRejectedThem) {
  const TemporaryFolder folder;
  DriveLog log(folder.file(""));
  log.flush();
  EXPECT_FALSE(std::filesystem::exists(folder.file("loop_candidates.csv")));
  LoopCandidate candidate{LoopOrigin::retroactive, {1}, {5}, {4}, {21}, "fitness", 0.18, 0.25, "%"};
  log.add(candidate);
  candidate.outcome = "accepted";
  log.add(candidate);
  EXPECT_EQ(textOf(folder.file("loop_candidates.csv")),
            "origin,target_map,source_map,target_submap,source_submap,outcome,value,limit,unit\n"
            "retroactive,1,5,4,21,fitness,0.18,0.25,%\n"
            "retroactive,1,5,4,21,accepted,,,\n");
  EXPECT_NO_THROW(log.flush());
}

TEST(DriveLog, WaitsForItsFolder) {
  const TemporaryFolder folder;
  DriveLog log(folder.file("later"));
  log.add(entryOf(scanAt(0), timesOf(0)));
  EXPECT_THROW(log.flush(), std::runtime_error);
  std::filesystem::create_directory(folder.file("later"));
  log.add(entryOf(scanAt(1), timesOf(1)));
  EXPECT_EQ(readTum(folder.file("later/odometry.tum")).size(), 2u);
  EXPECT_NO_THROW(log.flush());
}

TEST(DriveLog, BeginsAnewWhereItsFilesAreRemoved) {
  const TemporaryFolder folder;
  DriveLog log(folder.file(""));
  log.add(entryOf(scanAt(0), timesOf(0)));
  for (const char* name : {"odometry.tum", "odometry_information.csv", "scan_times.csv"})
    std::filesystem::remove(folder.file(name));
  log.add(entryOf(scanAt(1), timesOf(1)));
  EXPECT_NO_THROW(log.flush());
  EXPECT_EQ(readTum(folder.file("odometry.tum")).size(), 1u);
  EXPECT_EQ(textOf(folder.file("scan_times.csv")),
            "scan,stamp,register_ms,downsample_ms,total_ms\n1,1700000000.100000001,2,0.5,2.5\n");
}

TEST(DriveLog, TellsOfAllScans) {
  const TemporaryFolder folder;
  DriveLog log(folder.file(""));
  for (std::uint32_t i = 0; i < 3; ++i) log.add(entryOf(scanAt(i), timesOf(i)));
  log.addTimes({{"optimisation", 7.0}});
  RunSummary summary;
  log.tell(summary);
  EXPECT_EQ(summary.processed, 3u);
  EXPECT_EQ(summary.verdicts.at(PoseVerdict::good), 3u);
  EXPECT_DOUBLE_EQ(summary.path_length, 4.0);
  EXPECT_EQ(summary.stage_ms.at("register"), (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(summary.stage_ms.at("optimisation"), std::vector<float>{7});
}

}  // namespace
}  // namespace revisit_slam
