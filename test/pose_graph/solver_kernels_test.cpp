// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"

namespace revisit_slam {
namespace {

LapDrive rightDrive() {
  return lapDrive(1200, 300, 30);
}

/// A further loop says that the platform was 15 m aside and turned.
LapDrive driveWithAWrongLoop() {
  LapDrive drive = rightDrive();
  Constraint wrong = drive.graph.loops()[5];
  wrong.from.value += 60;
  wrong.T_from_to = wrong.T_from_to * Pose{expSO3({0.0, 0.0, 0.4}), {3.0, 15.0, 1.0}};
  drive.graph.addLoop(wrong);
  return drive;
}

struct Case {
  const char* kernel;
  double most_error;   ///< m, from the solution without the wrong loop
  double most_weight;  ///< of the wrong loop
};

class SolverKernels : public testing::TestWithParam<Case> {};

TEST_P(SolverKernels, AWrongLoopPullsAsMuchAsTheKernelAllows) {
  const auto [kernel, most_error, most_weight] = GetParam();
  const LapDrive drive = driveWithAWrongLoop();
  const PoseGraphSolution solution = solve(drive.graph, configWith(kernel));
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_LE(solution.final_cost, solution.initial_cost);
  const std::vector<Pose> without = solve(rightDrive().graph, configWith(kernel)).poses;
  EXPECT_LT(positionError(solution.poses, without), most_error);
  EXPECT_LT(solution.loops.back().weight, most_weight);
  if (most_weight > 0.1) return;
  for (std::size_t i = 0; i + 1 < solution.loops.size(); ++i)
    EXPECT_GT(solution.loops[i].weight, 0.1) << "right loop " << i;
}

INSTANTIATE_TEST_SUITE_P(AllKernels, SolverKernels,
                         testing::Values(Case{"none", 20.0, 1.1}, Case{"huber", 1.0, 0.1},
                                         Case{"cauchy", 0.05, 1e-3},
                                         Case{"geman_mcclure", 1e-3, 1e-5}),
                         [](const auto& info) { return std::string(info.param.kernel); });

TEST(SolverKernels, WithoutAKernelAWrongLoopBendsTheMap) {
  const LapDrive drive = driveWithAWrongLoop();
  const std::vector<Pose> without = solve(rightDrive().graph, configWith("none")).poses;
  EXPECT_GT(positionError(solve(drive.graph, configWith("none")).poses, without), 0.5);
}

/// Drift lets right loops start with residuals of hundreds of scales, where the kernel's own slope
/// vanishes.
TEST(SolverKernels, RightLoopsFarFromTheStartAreTaken) {
  const LapDrive drive = lapDrive(4000, 1000, 50);
  for (const char* kernel : {"cauchy", "geman_mcclure"}) {
    const PoseGraphSolution solution = solve(drive.graph, configWith(kernel));
    double farthest = 0.0;
    for (const LoopResidual& loop : solution.loops) {
      farthest = std::max(farthest, std::sqrt(loop.chi2_before));
      EXPECT_GT(loop.weight, 0.1) << kernel;
    }
    EXPECT_GT(farthest, 100.0);
    EXPECT_LT(positionError(solution.poses, drive.truth), 1.0) << kernel;
  }
}

}  // namespace
}  // namespace revisit_slam
