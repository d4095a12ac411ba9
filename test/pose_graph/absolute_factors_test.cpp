// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/chain_reduction.h"
#include "revisit_slam/pose_graph/gauge.h"
#include "revisit_slam/pose_graph/graduated_minimize.h"
#include "revisit_slam/pose_graph/graph_cost.h"

namespace revisit_slam {
namespace {

/// Not where the map has it: turned, and away.
const Pose kMisplaced{expSO3({0.02, -0.01, 0.3}), {8.0, -5.0, 2.0}};

PoseGraph movedBy(const Pose& T, const PoseGraph& graph) {
  PoseGraph moved;
  for (const Pose& pose : graph.poses()) moved.addNode(T * pose);
  for (const Factor& factor : graph.factors()) moved.addFactor(factor.measurement, factor.kernel);
  return moved;
}

/// A drive that starts misplaced, with loops and a position for every 100th node.
LapDrive driveWithPositions(const RobustKernel& kernel) {
  LapDrive drive = lapDrive(2000, 400, 40, kernelOf("cauchy"));
  for (const PositionFactor& position : positionsOf(drive.truth, 100))
    drive.graph.addFactor(position, kernel);
  drive.graph = movedBy(kMisplaced, drive.graph);
  return drive;
}

TEST(AbsoluteFactors, PlaceTheDriveInTheMap) {
  for (const char* kernel : {"none", "huber", "cauchy"}) {
    const LapDrive drive = driveWithPositions(kernelOf(kernel));
    ASSERT_TRUE(gaugeNodes(drive.graph).empty());
    const PoseGraphSolution solution = solve(drive.graph, exactConfig());
    EXPECT_EQ(solution.outcome, SolveOutcome::converged);
    EXPECT_GT(positionError(drive.graph.poses(), drive.truth), 5.0);
    EXPECT_LT(positionError(solution.poses, drive.truth), 0.15) << kernel;
    EXPECT_LT(distanceBetween(solution.poses[0], drive.truth[0]), 0.3) << kernel;
  }
}

TEST(AbsoluteFactors, TheReducedGraphLeadsToTheSameOptimum) {
  const LapDrive drive = driveWithPositions(kernelOf("huber"));
  const ChainReduction reduction(drive.graph);
  ASSERT_LT(10 * reduction.reduced().poses().size(), drive.graph.poses().size());
  EXPECT_TRUE(gaugeNodes(reduction.reduced()).empty());
  const MinimizeLimits limits{100, 1e-13};
  const Minimum whole = graduatedMinimize(drive.graph, drive.graph.poses(), limits);
  const Minimum reduced =
      graduatedMinimize(reduction.reduced(), reduction.reduced().poses(), limits);
  const double least = graphCost(drive.graph, whole.poses);
  const std::vector<Pose> expanded = reduction.expand(reduced.poses);
  EXPECT_LT(positionError(expanded, whole.poses), 0.01);
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_NEAR(solution.final_cost, least, 1e-8 * least);
  EXPECT_LT(positionError(solution.poses, whole.poses), 1e-4);
  EXPECT_LE(solution.iterations, 4);
}

TEST(AbsoluteFactors, CorrectADriveWithoutLoops) {
  LapDrive drive = lapDrive(2000, 400, 4000);
  for (const PositionFactor& position : positionsOf(drive.truth, 100))
    drive.graph.addFactor(position);
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_GT(positionError(drive.graph.poses(), drive.truth), 1.0);
  EXPECT_LT(positionError(solution.poses, drive.truth), 0.3);
}

TEST(AbsoluteFactors, AWrongPositionLosesItsWeight) {
  LapDrive drive = driveWithPositions(kernelOf("cauchy"));
  PositionFactor wrong = positionsOf(drive.truth, 100)[7];
  wrong.p_map += Eigen::Vector3d(0.0, 15.0, 0.0);
  drive.graph.addFactor(wrong, kernelOf("cauchy"));
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_LT(solution.factors.back().weight, 1e-2);
  EXPECT_LT(positionError(solution.poses, drive.truth), 0.15);
}

TEST(AbsoluteFactors, OnePositionPullsButTheFirstNodeStays) {
  LapDrive drive = lapDrive(200, 50, 10);
  PositionFactor position{{NodeId{100}}};
  position.p_map = drive.truth[100].translation;
  position.information *= 1e6;
  drive.graph.addFactor(position);
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_EQ(solution.poses[0].matrix(), drive.graph.poses()[0].matrix());
  EXPECT_LT((solution.poses[100].translation - position.p_map).norm(), 0.01);
}

}  // namespace
}  // namespace revisit_slam
