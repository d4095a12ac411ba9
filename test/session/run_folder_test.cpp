// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "revisit_slam/odometry/odometry_config.h"
#include "session/logged_drive.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

RunSummary someSummary(OdometryConfig& config) {
  RunSummary summary;
  summary.parameters = parametersOf(config);
  summary.input.emplace();
  summary.input->account = {204, 201, 20, 0, {{"empty", 1}, {"late", 2}}, 9000, {{"too_far", 70}}};
  summary.topic = "/points";
  summary.tracked_frame = "base_link";
  summary.input->time_source = "field 'time'";
  summary.wall_seconds = 12.5;
  summary.reading_cpu_seconds = 0.1;
  summary.threads = 2;
  return summary;
}

TEST(RunFolder, SummaryAccountsForTheRun) {
  const TemporaryFolder parent;
  RunFolder folder(parent.file("run"));
  for (std::uint32_t i = 0; i < 201; ++i) folder.log().add(entryOf(scanAt(i), timesOf(i)));
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
    folder.log().add(entryOf(scanAt(0), timesOf(0)));
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
