// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "revisit_slam/odometry/odometry_config.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

/// Scan i is at x = 2 i and took i + 1 ms to register; a whole run has 201.
InformedScan scanAt(std::uint32_t i) {
  auto scan = std::make_shared<RegisteredScan>();
  scan->id = {i};
  scan->stamp = {1'700'000'000'000'000'001 + i * 100'000'000LL};
  scan->T_odom_base.translation = {5.0 + 2.0 * i, 0, 0};
  InformedScan informed;
  informed.scan = scan;
  return informed;
}

StageTimes timesOf(std::uint32_t i) {
  return {{"register", i + 1.0}, {"downsample", 0.5}};
}

RunSummary someSummary(OdometryConfig& config) {
  RunSummary summary;
  summary.parameters = parametersOf(config);
  summary.account = {204, 201, 20, 0, {{"empty", 1}, {"late", 2}}, 9000, {{"too_far", 70}}};
  summary.topic = "/points";
  summary.tracked_frame = "base_link";
  summary.time_source = "field 'time'";
  summary.wall_seconds = 12.5;
  summary.reading_cpu_seconds = 0.1;
  summary.threads = 2;
  return summary;
}

TEST(RunFolder, PosesCanBeReadWhileTheRunIsOpen) {
  const TemporaryFolder parent;
  RunFolder folder(parent.file("with/its/parents"));
  for (std::uint32_t i = 0; i < 3; ++i) {
    folder.add(scanAt(i), timesOf(i));
    const Trajectory read = readTum(folder.file("odometry.tum"));
    ASSERT_EQ(read.size(), i + 1);
    EXPECT_EQ(read.back().stamp, scanAt(i).scan->stamp);
    EXPECT_EQ(read.back().T_world_base.translation, scanAt(i).scan->T_odom_base.translation);
  }
}

TEST(RunFolder, ScanTimesHaveAColumnForEachStageAndTheirSum) {
  const TemporaryFolder parent;
  {
    RunFolder folder(parent.file("run"));
    for (std::uint32_t i = 0; i < 2; ++i) folder.add(scanAt(i), timesOf(i));
  }
  EXPECT_EQ(textOf(parent.file("run/scan_times.csv")),
            "scan,stamp,register_ms,downsample_ms,total_ms\n"
            "0,1700000000.000000001,1,0.5,1.5\n"
            "1,1700000000.100000001,2,0.5,2.5\n");
}

TEST(RunFolder, InformationHasTheUpperTrianglesOfBothMatrices) {
  const TemporaryFolder parent;
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
  expected += ",good,0";
  RunFolder(parent.file("run")).add(informed, timesOf(0));
  std::istringstream lines(textOf(parent.file("run/odometry_information.csv")));
  std::string header, line;
  ASSERT_TRUE(std::getline(lines, header) && std::getline(lines, line));
  EXPECT_EQ(header.find("scan,stamp,source,mean_squared_residual,weak_directions,information11,"
                        "information12"),
            0u);
  EXPECT_NE(header.find(",information66,covariance11,"), std::string::npos);
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 4 + 2 * 21 + 2);
  EXPECT_EQ(line, expected);
}

TEST(RunFolder, SummaryAccountsForTheRun) {
  const TemporaryFolder parent;
  RunFolder folder(parent.file("run"));
  for (std::uint32_t i = 0; i < 201; ++i) folder.add(scanAt(i), timesOf(i));
  OdometryConfig config;
  const RunSummary summary = someSummary(config);
  folder.finish(summary);
  const auto run = nlohmann::json::parse(textOf(folder.file("run.json")));
  EXPECT_EQ(run["scans"],
            nlohmann::json::parse(R"({"received": 204, "processed": 201, "at_rest": 20, "joined": 0,
                                                    "dropped": {"empty": 1, "late": 2}})"));
  EXPECT_EQ(run["poses"], nlohmann::json::parse(R"({"good": 201})"));
  EXPECT_EQ(run["points"],
            nlohmann::json::parse(R"({"received": 9000, "dropped": {"too_far": 70}})"));
  EXPECT_EQ(run["stages_ms"]["register"],
            nlohmann::json::parse(R"({"median": 101.0, "p99": 199.0, "max": 201.0})"));
  EXPECT_EQ(run["stages_ms"]["total"]["median"], 101.5);
  EXPECT_EQ(run["stages_ms"]["downsample"]["p99"], 0.5);
  EXPECT_DOUBLE_EQ(run["path_length_m"], 400.0);
  EXPECT_NEAR(run["cpu_seconds_per_scan"],
              (run["cpu_seconds"].get<double>() - summary.reading_cpu_seconds) / 201, 1e-3);
  EXPECT_EQ(run["wall_seconds"], 12.5);
  EXPECT_EQ(run["parameters"]["map"]["voxel_size"], OdometryConfig{}.map.voxel_size);
  EXPECT_EQ(run["topic"], "/points");
  EXPECT_EQ(run["tracked_frame"], "base_link");
  EXPECT_EQ(run["time_source"], "field 'time'");
  EXPECT_EQ(run["threads"], 2);
  EXPECT_FALSE(run["version"].get<std::string>().empty());
  EXPECT_GT(run["cpu_seconds"], 0.0);
  EXPECT_GT(run["peak_memory_mb"], 1.0);
}

TEST(RunFolder, ARunWithoutScansHasASummaryToo) {
  const TemporaryFolder parent;
  RunFolder folder(parent.file("run"));
  folder.finish({});
  const auto run = nlohmann::json::parse(textOf(folder.file("run.json")));
  EXPECT_EQ(run["scans"]["processed"], 0);
  EXPECT_EQ(run["path_length_m"], 0.0);
  EXPECT_TRUE(run["stages_ms"].empty());
}

TEST(RunFolder, AFolderWithResultsOrInUseIsLeftAlone) {
  const TemporaryFolder parent;
  {
    RunFolder folder(parent.file("run"));
    folder.add(scanAt(0), timesOf(0));
    EXPECT_THROW(RunFolder(parent.file("run")), std::runtime_error);
  }
  const std::string before = textOf(parent.file("run/odometry.tum"));
  EXPECT_THROW(RunFolder(parent.file("run")), std::runtime_error);
  EXPECT_EQ(textOf(parent.file("run/odometry.tum")), before);
}

TEST(RunFolder, NamesTheFolderThatItCannotMake) {
  const TemporaryFolder parent;
  const std::string path = parent.with("file", "") + "/run";
  try {
    RunFolder folder(path);
    FAIL() << "made a folder within a file";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace revisit_slam
