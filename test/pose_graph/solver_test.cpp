// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/solver.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <limits>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/graph_cost.h"
#include "revisit_slam/pose_graph/minimize.h"

namespace revisit_slam {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbersOf(const PoseGraphSolution& solution) {
  std::vector<double> numbers{solution.initial_cost, solution.final_cost};
  for (const Pose& T : solution.poses) {
    numbers.insert(numbers.end(), T.translation.data(), T.translation.data() + 3);
    numbers.insert(numbers.end(), T.rotation.coeffs().data(), T.rotation.coeffs().data() + 4);
  }
  return numbers;
}

void expectSameBytes(const PoseGraphSolution& a, const PoseGraphSolution& b) {
  const std::vector<double> x = numbersOf(a), y = numbersOf(b);
  ASSERT_EQ(x.size(), y.size());
  EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(double)), 0);
}

PoseGraph twoNodes() {
  PoseGraph graph;
  graph.addNode({});
  graph.addNode({Eigen::Quaterniond::Identity(), {1.0, 0.0, 0.0}});
  graph.addFactor(
      RelativePoseFactor{{NodeId{0}, NodeId{1}}, graph.poses()[1], Matrix6::Identity()});
  return graph;
}

TEST(Solver, ClosesLoopsOfALongDrive) {
  const LapDrive drive = lapDrive(2000, 400, 40);
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_GT(positionError(drive.graph.poses(), drive.truth), 1.0);
  EXPECT_LT(positionError(solution.poses, drive.truth), 0.5);
  EXPECT_LT(solution.final_cost, 1e-2 * solution.initial_cost);
  EXPECT_LE(solution.iterations, 3);
  EXPECT_LT(solution.seconds, 3.0);
  ASSERT_EQ(solution.factors.size(), drive.graph.factors().size());
  for (const FactorResidual& factor : solution.factors) EXPECT_LT(factor.chi2_after, 60.0);
}

TEST(Solver, EndsWhereTheWholeGraphAloneWouldHave) {
  const LapDrive drive = lapDrive(2000, 400, 40);
  const Minimum whole = minimize(drive.graph, drive.graph.poses(), {100, 1e-13});
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  const double least = graphCost(drive.graph, whole.poses);
  EXPECT_NEAR(solution.final_cost, least, 1e-8 * least);
  EXPECT_LT(positionError(solution.poses, whole.poses), 1e-4);
}

TEST(Solver, WeighsByTheCorrelatedInformation) {
  PoseGraph graph = twoNodes();
  Tangent d;
  d << 0.02, -0.01, 0.03, 0.01, 0.02, -0.01;
  const Matrix6 odometry = correlatedInformation(0.1, 0.05),
                loop = correlatedInformation(0.05, 0.1);
  PoseGraph weighed;
  for (const Pose& T : graph.poses()) weighed.addNode(T);
  const Pose Z = graph.poses()[1];
  weighed.addFactor(RelativePoseFactor{{NodeId{0}, NodeId{1}}, Z, odometry});
  weighed.addFactor(RelativePoseFactor{{NodeId{0}, NodeId{1}}, boxplus(Z, 1e-3 * d), loop});
  const PoseGraphSolution solution = solve(weighed, exactConfig());
  const Tangent expected = (odometry + loop).inverse() * loop * (1e-3 * d);
  EXPECT_LT((log(Z.inverse() * solution.poses[1]) - expected).norm(), 1e-3 * expected.norm());
}

TEST(Solver, NeverMovesTheFirstNode) {
  const LapDrive drive = lapDrive(200, 50, 10, kernelOf("cauchy"));
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.poses[0].matrix(), drive.graph.poses()[0].matrix());
}

TEST(Solver, GivesTheSameBytesAgainAndForAnyNumberOfThreads) {
  for (const char* kernel : {"none", "cauchy"}) {
    const LapDrive drive = lapDrive(2000, 400, 40, kernelOf(kernel));
    SolverConfig config = exactConfig();
    config.threads = 1;
    const PoseGraphSolution first = solve(drive.graph, config);
    expectSameBytes(first, solve(drive.graph, config));
    config.threads = 4;
    expectSameBytes(first, solve(drive.graph, config));
  }
}

TEST(Solver, StartsFromTheGivenPoses) {
  LapDrive drive = lapDrive(500, 100, 20);
  const PoseGraphSolution cold = solve(drive.graph, exactConfig());
  drive.graph.correct(cold.poses);
  const PoseGraphSolution warm = solve(drive.graph, exactConfig());
  EXPECT_EQ(warm.outcome, SolveOutcome::converged);
  EXPECT_NEAR(warm.initial_cost, cold.final_cost, 1e-12 * cold.final_cost);
  EXPECT_LE(warm.final_cost, warm.initial_cost);
  EXPECT_LE(warm.iterations, 1);
}

TEST(Solver, WithoutLoopsThereIsNothingToDo) {
  EXPECT_EQ(solve(PoseGraph(), SolverConfig()).outcome, SolveOutcome::no_loops);
  const PoseGraphSolution solution = solve(twoNodes(), SolverConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::no_loops);
  EXPECT_EQ(solution.poses.size(), 2u);
  EXPECT_FALSE(solution.usable());
}

/// As of a survey that ends at two known points.
TEST(Solver, AChainBetweenHeldEndsIsBent) {
  PoseGraph graph;
  for (int i = 0; i < 5; ++i)
    graph.addNode({Eigen::Quaterniond::Identity(), {i < 4 ? 1.0 * i : 4.4, 0.0, 0.0}});
  for (std::uint32_t i = 1; i < 5; ++i)
    graph.addFactor(RelativePoseFactor{{NodeId{i - 1}, NodeId{i}},
                                       {Eigen::Quaterniond::Identity(), {1.0, 0.0, 0.0}},
                                       Matrix6::Identity()});
  for (const std::uint32_t end : {0u, 4u}) graph.hold(NodeId{end});
  const PoseGraphSolution solution = solve(graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(solution.poses[static_cast<std::size_t>(i)].translation.x(), 1.1 * i, 1e-6) << i;
}

TEST(Solver, PartsWithoutConnectionStayWhereTheyAre) {
  LapDrive drive = lapDrive(200, 50, 10);
  const Pose alone{expSO3({0.1, 0.2, 0.3}), {7.0, 8.0, 9.0}};
  const NodeId node = drive.graph.addNode(alone);
  const PoseGraphSolution solution = solve(drive.graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_EQ(solution.poses[node.value].matrix(), alone.matrix());
  EXPECT_LT(positionError(solution.poses, drive.truth), 0.5);
}

TEST(Solver, NumbersThatAreNotFiniteFailAndLeaveThePoses) {
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity()})
    for (const bool in_information : {true, false}) {
      PoseGraph graph = twoNodes();
      RelativePoseFactor loop{{NodeId{0}, NodeId{1}}, {}, Matrix6::Identity()};
      (in_information ? loop.information(2, 3) : loop.T_from_to.translation[1]) = bad;
      graph.addFactor(loop);
      const PoseGraphSolution solution = solve(graph, SolverConfig());
      EXPECT_EQ(solution.outcome, SolveOutcome::failed);
      EXPECT_EQ(solution.poses[1].matrix(), graph.poses()[1].matrix());
      EXPECT_EQ(solution.factors.size(), 2u);
    }
}

TEST(Solver, InformationTooLargeToSquareFails) {
  PoseGraph graph = twoNodes();
  graph.addFactor(RelativePoseFactor{{NodeId{0}, NodeId{1}}, {}, 1e308 * Matrix6::Ones()});
  const PoseGraphSolution solution = solve(graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::failed);
  EXPECT_EQ(solution.poses[1].matrix(), graph.poses()[1].matrix());
}

TEST(Solver, UnknownDirectionsDoNotMatter) {
  PoseGraph graph = twoNodes();
  Matrix6 along_x = Matrix6::Zero();
  along_x(0, 0) = 3.0;
  const Pose farther{Eigen::Quaterniond::Identity(), {2.0, 0.0, 0.0}};
  graph.addFactor(RelativePoseFactor{{NodeId{0}, NodeId{1}}, farther, along_x});
  const PoseGraphSolution solution = solve(graph, exactConfig());
  EXPECT_EQ(solution.outcome, SolveOutcome::converged);
  EXPECT_LT((solution.poses[1].translation - Eigen::Vector3d(1.75, 0, 0)).norm(), 1e-6);
}

TEST(Solver, StopsAtTheIterationsAllowed) {
  SolverConfig config = exactConfig();
  config.max_iterations = 1;
  config.function_tolerance = 1e-15;
  const LapDrive drive = lapDrive(60, 20, 1);  // nearly all nodes have loops: nothing to reduce
  const PoseGraphSolution solution = solve(drive.graph, config);
  EXPECT_EQ(solution.outcome, SolveOutcome::max_iterations);
  EXPECT_LT(solution.final_cost, solution.initial_cost);
}

}  // namespace
}  // namespace revisit_slam
