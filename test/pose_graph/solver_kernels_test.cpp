// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"

namespace revisit_slam {
namespace {

LapDrive rightDrive(const RobustKernel& kernel) {
  return lapDrive(1200, 300, 30, kernel);
}

/// A further loop says that the platform was 15 m aside and turned.
LapDrive driveWithAWrongLoop(const RobustKernel& kernel) {
  LapDrive drive = rightDrive(kernel);
  RelativePoseFactor wrong = drive.loops[5];
  wrong.nodes[0].value += 60;
  wrong.T_from_to = wrong.T_from_to * Pose{expSO3({0.0, 0.0, 0.4}), {3.0, 15.0, 1.0}};
  drive.graph.addFactor(wrong, kernel);
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
  const LapDrive right = rightDrive(kernelOf(kernel));
  const LapDrive drive = driveWithAWrongLoop(kernelOf(kernel));
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_LE(solution.final_cost, solution.initial_cost);
  const std::vector<Pose> without = solve(right.graph, exactConfig()).poses;
  EXPECT_LT(positionError(solution.poses, without), most_error);
  EXPECT_LT(solution.factors.back().weight, most_weight);
  if (most_weight > 0.1) return;
  for (std::size_t i = 0; i + 1 < solution.factors.size(); ++i)
    EXPECT_GT(solution.factors[i].weight, 0.1) << "right factor " << i;
}

INSTANTIATE_TEST_SUITE_P(AllKernels, SolverKernels,
                         testing::Values(Case{"none", 20.0, 1.1}, Case{"huber", 1.0, 0.1},
                                         Case{"cauchy", 0.05, 1e-3},
                                         Case{"geman_mcclure", 1e-3, 1e-5}),
                         [](const auto& info) { return std::string(info.param.kernel); });

TEST(SolverKernels, WithoutAKernelAWrongLoopBendsTheMap) {
  const LapDrive drive = driveWithAWrongLoop({});
  const std::vector<Pose> without = solve(rightDrive({}).graph, exactConfig()).poses;
  EXPECT_GT(positionError(solve(drive.graph, exactConfig()).poses, without), 0.5);
}

/// Drift lets right loops start with residuals of hundreds of scales, where the kernel's own slope
/// vanishes.
TEST(SolverKernels, RightLoopsFarFromTheStartAreTaken) {
  for (const char* kernel : {"cauchy", "geman_mcclure"}) {
    const LapDrive drive = lapDrive(4000, 1000, 50, kernelOf(kernel));
    const PoseGraphSolution solution = solve(drive.graph, exactConfig());
    double farthest = 0.0;
    for (const FactorResidual& factor : solution.factors) {
      farthest = std::max(farthest, std::sqrt(factor.chi2_before));
      EXPECT_GT(factor.weight, 0.1) << kernel;
    }
    EXPECT_GT(farthest, 100.0);
    EXPECT_LT(positionError(solution.poses, drive.truth), 1.0) << kernel;
  }
}

TEST(SolverKernels, EveryFactorHasItsOwn) {
  LapDrive drive = driveWithAWrongLoop(kernelOf("geman_mcclure"));
  PositionFactor far{{NodeId{700}}};
  far.p_map = drive.truth[700].translation + Eigen::Vector3d(0.0, 20.0, 0.0);
  far.information *= 100.0;
  const FactorId position = drive.graph.addFactor(far, kernelOf("huber", 2.0));
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_LT(solution.factors[position.value - 1].weight, 1e-5);  // the wrong loop
  const FactorResidual& residual = solution.factors[position.value];
  EXPECT_NEAR(residual.weight, 2.0 / std::sqrt(residual.chi2_after), 1e-9);
  EXPECT_EQ(solution.factors[0].weight, 1.0);
}

}  // namespace
}  // namespace revisit_slam
