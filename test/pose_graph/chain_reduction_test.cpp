// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_reduction.h"

#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"

namespace revisit_slam {
namespace {

RelativePoseFactor between(std::uint32_t from, std::uint32_t to) {
  return {{NodeId{from}, NodeId{to}},
          {Eigen::Quaterniond::Identity(), {1.0 * to - from, 0.0, 0.0}},
          Matrix6::Identity()};
}

PoseGraph chainOf(std::uint32_t nodes) {
  PoseGraph graph;
  for (std::uint32_t i = 0; i < nodes; ++i)
    graph.addNode({Eigen::Quaterniond::Identity(), {1.0 * i, 0.0, 0.0}});
  for (std::uint32_t i = 1; i < nodes; ++i) graph.addFactor(between(i - 1, i));
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
  graph.addFactor(between(10, 60));
  const ChainReduction reduction(graph);
  ASSERT_EQ(reduction.reduced().poses().size(), 4u);  // 0, 10, 60, 99
  const std::vector<Factor>& factors = reduction.reduced().factors();
  ASSERT_EQ(factors.size(), 4u);
  ASSERT_NE(chainLink(factors[1]), nullptr);
  EXPECT_EQ(chainLink(factors[1])->T_from_to.translation.x(), 50.0);
  const auto& loop = std::get<RelativePoseFactor>(factors[3].measurement);
  EXPECT_EQ(loop.nodes, (std::array<NodeId, 2>{NodeId{1}, NodeId{2}}));
  expectSamePoses(graph);
}

TEST(ChainReduction, KeepsWhatIsNoChain) {
  PoseGraph graph = chainOf(20);
  graph.addNode({});  // without constraints
  graph.addNode({Eigen::Quaterniond::Identity(), {8.0, 0.0, 0.0}});
  graph.addFactor(between(7, 21));  // a branch
  graph.addFactor(between(15, 3));
  EXPECT_EQ(ChainReduction(graph).reduced().poses().size(), 7u);  // 0, 3, 7, 15, 19, 20, 21
  expectSamePoses(graph);
}

TEST(ChainReduction, KeepsAbsoluteFactorsWithTheirKernels) {
  PoseGraph graph = chainOf(50);
  graph.addFactor(PositionFactor{{NodeId{20}}, {0.0, 0.0, 2.0}, {7.0, 8.0, 9.0}},
                  RobustKernel{KernelType::huber, 3.0});
  const ChainReduction reduction(graph);
  ASSERT_EQ(reduction.reduced().poses().size(), 3u);  // 0, 20, 49
  ASSERT_EQ(reduction.reduced().factors().size(), 3u);
  const Factor& kept = reduction.reduced().factors().back();
  EXPECT_EQ(*kept.nodes().begin(), NodeId{1});
  EXPECT_EQ(kept.kernel.type, KernelType::huber);
  EXPECT_EQ(kept.kernel.scale, 3.0);
  EXPECT_EQ(std::get<PositionFactor>(kept.measurement).p_map, Eigen::Vector3d(7.0, 8.0, 9.0));
  expectSamePoses(graph);
}

TEST(ChainReduction, LeavesOutWhatIsSettled) {
  PoseGraph graph = chainOf(100);
  graph.addFactor(between(10, 20));  // of held nodes
  graph.addFactor(between(30, 80));
  for (std::uint32_t i = 0; i < 50; ++i) graph.hold(NodeId{i});
  const ChainReduction reduction(graph);
  ASSERT_EQ(reduction.reduced().poses().size(), 4u);  // 30, 49, 80, 99
  EXPECT_EQ(reduction.reduced().factors().size(), 3u);
  for (const std::uint32_t i : {0u, 1u}) EXPECT_TRUE(reduction.reduced().isHeld(NodeId{i}));
  for (const std::uint32_t i : {2u, 3u}) EXPECT_FALSE(reduction.reduced().isHeld(NodeId{i}));
  expectSamePoses(graph);
}

TEST(ChainReduction, OdometryMeasuredTwiceIsNoChain) {
  PoseGraph graph = chainOf(10);
  graph.addFactor(between(4, 5));
  EXPECT_EQ(ChainReduction(graph).reduced().poses().size(), 4u);  // 0, 4, 5, 9
  expectSamePoses(graph);
}

TEST(ChainReduction, OfTheEmptyGraphIsEmpty) {
  expectSamePoses(PoseGraph());
  expectSamePoses(chainOf(1));
}

}  // namespace
}  // namespace revisit_slam
