// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_reduction.h"

#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"

namespace revisit_slam {
namespace {

Constraint between(std::uint32_t from, std::uint32_t to) {
  return {ScanId{from}, ScanId{to}, {Eigen::Quaterniond::Identity(), {1.0, 0.0, 0.0}}, {}};
}

Constraint identityBetween(std::uint32_t from, std::uint32_t to) {
  Constraint constraint = between(from, to);
  constraint.information.setIdentity();
  return constraint;
}

PoseGraph chainOf(std::uint32_t nodes) {
  PoseGraph graph;
  for (std::uint32_t i = 0; i < nodes; ++i)
    graph.addNode({Eigen::Quaterniond::Identity(), {1.0 * i, 0.0, 0.0}});
  for (std::uint32_t i = 1; i < nodes; ++i) graph.addOdometry(identityBetween(i - 1, i));
  return graph;
}

void expectSamePoses(const PoseGraph& graph) {
  const ChainReduction reduction(graph);
  const std::vector<Pose> expanded = reduction.expand(reduction.reduced().poses());
  ASSERT_EQ(expanded.size(), graph.poses().size());
  for (std::size_t i = 0; i < expanded.size(); ++i)
    EXPECT_LT(distanceBetween(expanded[i], graph.poses()[i]), 1e-9) << i;
}

TEST(ChainReduction, KeepsEndsAndNodesWithLoops) {
  PoseGraph graph = chainOf(100);
  graph.addLoop(identityBetween(10, 60));
  const ChainReduction reduction(graph);
  ASSERT_EQ(reduction.reduced().poses().size(), 4u);  // 0, 10, 60, 99
  ASSERT_EQ(reduction.reduced().odometry().size(), 3u);
  EXPECT_EQ(reduction.reduced().odometry()[1].T_from_to.translation.x(), 50.0);
  EXPECT_EQ(reduction.reduced().loops()[0].to, ScanId{2});
  expectSamePoses(graph);
}

TEST(ChainReduction, KeepsWhatIsNoChain) {
  PoseGraph graph = chainOf(20);
  graph.addNode({});  // without constraints
  graph.addNode({Eigen::Quaterniond::Identity(), {8.0, 0.0, 0.0}});
  graph.addOdometry(identityBetween(7, 21));  // a branch
  Constraint backwards = identityBetween(15, 3);
  backwards.T_from_to.translation.x() = -12.0;
  graph.addOdometry(backwards);
  EXPECT_EQ(ChainReduction(graph).reduced().poses().size(), 7u);  // 0, 3, 7, 15, 19, 20, 21
  expectSamePoses(graph);
}

TEST(ChainReduction, OfTheEmptyGraphIsEmpty) {
  expectSamePoses(PoseGraph());
  expectSamePoses(chainOf(1));
}

}  // namespace
}  // namespace revisit_slam
