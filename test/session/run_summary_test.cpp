// SPDX-License-Identifier: MIT
#include "revisit_slam/session/run_summary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

TEST(RunSummary, LeavesOutWhatIsNotKnown) {
  const TemporaryFolder folder;
  RunSummary summary;
  summary.processed = 3;
  writeRunSummary(folder.file("run.json"), summary);
  const auto live = nlohmann::json::parse(textOf(folder.file("run.json")));
  EXPECT_EQ(live["scans"], nlohmann::json::parse(R"({"processed": 3})"));
  for (const char* key : {"points", "priors", "time_source", "wall_seconds", "finish_seconds",
                          "memory_mb_per_km", "retroactive_pairs"})
    EXPECT_FALSE(live.contains(key)) << key;

  summary.input.emplace();
  summary.input->priors["gyro"].bias = Eigen::Vector3d(0.5, 0.25, -1.0);
  SensorAccount& front = summary.input->lidars["/front"];
  front.messages = 7;
  front.points = 100;
  front.points_dropped["too late"] = 3;
  summary.wall_seconds = 2.0;
  summary.finish_seconds = 0.0;
  summary.memory_mb_per_km = 40.0;
  summary.retroactive_pairs = 0;
  writeRunSummary(folder.file("run.json"), summary);
  const auto offline = nlohmann::json::parse(textOf(folder.file("run.json")));
  EXPECT_EQ(offline["scans"]["received"], 0);
  EXPECT_EQ(offline["priors"]["gyro"]["bias"], nlohmann::json::parse("[0.5, 0.25, -1.0]"));
  EXPECT_FALSE(offline["priors"]["gyro"].contains("scale"));
  EXPECT_EQ(offline["lidars"]["/front"]["messages"], 7);
  EXPECT_EQ(offline["lidars"]["/front"]["points"]["dropped"]["too late"], 3);
  for (const char* key : {"points", "time_source", "wall_seconds", "finish_seconds",
                          "memory_mb_per_km", "retroactive_pairs"})
    EXPECT_TRUE(offline.contains(key)) << key;
}

}  // namespace
}  // namespace revisit_slam
