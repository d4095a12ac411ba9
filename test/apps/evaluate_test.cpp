// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "revisit_slam/io/trajectory.h"
#include "support/child_process.h"
#include "support/contains.h"
#include "support/scan_bag.h"
#include "support/scan_clouds.h"

namespace revisit_slam {
namespace {

/// The same way through the room twice, a hundred seconds apart.
class EvaluateProgram : public testing::Test {
 protected:
  EvaluateProgram() {
    Drive drive = driveInRoom(12);
    Trajectory truth;
    const std::size_t count = drive.scans.size();
    for (std::size_t i = 0; i < 2 * count; ++i) {
      Scan scan = drive.scans[i % count];
      if (i >= count) scan.stamp = scan.stamp.plusSeconds(100.0);
      if (i >= count) drive.scans.push_back(scan);
      truth.push_back({scan.stamp, drive.T_first_base[i % count] * scan.T_base_sensor});
    }
    writeScanBag(folder_.file("drive.bag"), toClouds(drive));
    writeTum(folder_.file("truth.tum"), truth);
    for (std::size_t i = count; i < 2 * count; ++i) truth[i].T_world_base.translation.z() += 0.3;
    writeTum(folder_.file("raised.tum"), truth);
  }

  int run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), REVISIT_SLAM_EVALUATE_PROGRAM);
    ChildProcess process(arguments, folder_.file(""));
    const int status = process.wait(60.0);
    output_ = process.output();
    return status;
  }
  nlohmann::json results(const std::string& out) const {
    return nlohmann::json::parse(textOf(folder_.file(out + "/evaluation.json")));
  }

  TemporaryFolder folder_;
  std::string output_;
};

TEST_F(EvaluateProgram, judgesTrajectoriesAndMapsOfSeveralEstimates) {
  ASSERT_EQ(run({"--reference", "truth.tum", "--estimate", "same=truth.tum", "--estimate",
                 "raised=raised.tum", "--bag", "drive.bag", "--out", "out"}),
            0)
      << output_;
  EXPECT_TRUE(contains(output_, "pooled RMS [m]")) << output_;
  const nlohmann::json same = results("out")["estimates"][0],
                       raised = results("out")["estimates"][1];
  EXPECT_EQ(raised["name"], "raised");
  EXPECT_LT(same["ate"]["rmse_m"], 1e-8);
  EXPECT_GT(raised["ate"]["rmse_m"], 0.1);
  EXPECT_TRUE(same["rpe"]["translation_percent"].is_null());
  EXPECT_LT(same["consistency"]["of_pairs"]["mean_rms_m"], 1e-3);  // the very same scans
  EXPECT_GT(raised["consistency"]["of_pairs"]["mean_rms_m"], 0.1);
  // Of each pass the first: the motion within it is not known.
  EXPECT_EQ(raised["consistency"]["scans_without_pose"], 2);
  EXPECT_TRUE(contains(textOf(folder_.file("out/worst_cells_raised.csv")), "\n0,1,"));
  EXPECT_TRUE(contains(textOf(folder_.file("out/poses_same.csv")), "reference_x"));
}

TEST_F(EvaluateProgram, judgesMapsWithoutAReference) {
  ASSERT_EQ(run({"--estimate", "raised=raised.tum", "--bag", "drive.bag", "--out", "out"}), 0)
      << output_;
  const nlohmann::json raised = results("out")["estimates"][0];
  EXPECT_FALSE(raised.contains("ate"));
  EXPECT_GT(raised["consistency"]["of_pairs"]["mean_rms_m"], 0.1);
}

TEST_F(EvaluateProgram, saysWhatIsWrongWithItsArguments) {
  EXPECT_EQ(run({"--estimate", "a=truth.tum"}), 1);
  EXPECT_TRUE(contains(output_, "give --reference, --bag or both")) << output_;
  EXPECT_EQ(run({"--reference", "truth.tum", "--estimate", "truth.tum"}), 1);
  EXPECT_TRUE(contains(output_, "NAME=FILE")) << output_;
  EXPECT_EQ(run({"--reference", "none.tum", "--estimate", "a=truth.tum"}), 1);
  EXPECT_TRUE(contains(output_, "none.tum")) << output_;
  EXPECT_EQ(
      run({"--reference", "truth.tum", "--estimate", "a=truth.tum", "--set", "consistency/cell=3"}),
      1);
  EXPECT_TRUE(contains(output_, "consistency/cell")) << output_;
  EXPECT_EQ(run({"--estimate", "a=truth.tum", "--bag", "drive.bag", "--set", "input/topics=/a /b"}),
            1);
  EXPECT_TRUE(contains(output_, "input/topics")) << output_;
}

}  // namespace
}  // namespace revisit_slam
