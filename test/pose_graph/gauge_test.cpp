// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gauge.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr double kFar = 5000.0;  // m, from the origin of the map

using Places = std::vector<Eigen::Vector3d>;

RelativePoseFactor between(std::uint32_t from, std::uint32_t to) {
  return {{NodeId{from}, NodeId{to}}, {}};
}

/// A chain through these places, turned at random, of whose nodes all have their position measured.
PoseGraph measuredAt(const Places& places, double sigma) {
  RandomNumbers random(1);
  PoseGraph graph;
  const Eigen::Vector3d away(kFar, -kFar, 0.0);
  for (const Eigen::Vector3d& place : places) {
    const NodeId node = graph.addNode({random.pose(1.0).rotation, away + place});
    if (node.value > 0) graph.addFactor(between(node.value - 1, node.value));
    graph.addFactor(PositionFactor{{node},
                                   Eigen::Vector3d::Zero(),
                                   away + place,
                                   Eigen::Matrix3d::Identity() / (sigma * sigma)});
  }
  return graph;
}

TEST(Gauge, EveryConnectedPartHasItsOwn) {
  PoseGraph graph;
  for (int i = 0; i < 7; ++i) graph.addNode({});
  graph.addFactor(between(0, 1));
  graph.addFactor(between(5, 4));
  graph.addFactor(between(2, 1));
  graph.addFactor(between(6, 5));
  EXPECT_EQ(gaugeNodes(graph), (std::vector<NodeId>{{0}, {3}, {4}}));
  EXPECT_TRUE(gaugeNodes(PoseGraph()).empty());
}

TEST(Gauge, OfAPartWithHeldNodesIsTheseAlone) {
  PoseGraph graph;
  for (int i = 0; i < 6; ++i) graph.addNode({});
  for (std::uint32_t i : {1u, 2u, 5u}) graph.addFactor(between(i - 1, i));
  graph.hold(NodeId{1});
  graph.hold(NodeId{2});
  EXPECT_EQ(gaugeNodes(graph), (std::vector<NodeId>{{1}, {2}, {3}, {4}}));
}

TEST(Gauge, StaysWherePositionsLeaveAPartFreeToTurn) {
  const std::vector<NodeId> first{NodeId{0}};
  EXPECT_EQ(gaugeNodes(measuredAt({{0, 0, 0}}, 0.1)), first);
  EXPECT_EQ(gaugeNodes(measuredAt({{0, 0, 0}, {90, 0, 0}}, 0.1)), first);
  EXPECT_EQ(gaugeNodes(measuredAt({{0, 0, 0}, {40, 20, 10}, {80, 40, 20}}, 0.1)), first);
}

TEST(Gauge, GoesWherePositionsDetermineThePart) {
  const Places corner{{0, 0, 0}, {40, 0, 0}, {40, 30, 5}};
  EXPECT_TRUE(gaugeNodes(measuredAt(corner, 0.1)).empty());
  EXPECT_EQ(gaugeNodes(measuredAt(corner, 10.0)).size(), 1u);  // 10 m of 30 m: more than 0.1 rad
}

TEST(Gauge, OfOtherPartsDoesNotDependOnAPartThatIsDetermined) {
  PoseGraph graph = measuredAt({{0, 0, 0}, {40, 0, 0}, {40, 30, 5}}, 0.1);
  const NodeId alone = graph.addNode({});
  EXPECT_EQ(gaugeNodes(graph), std::vector<NodeId>{alone});
}

}  // namespace
}  // namespace revisit_slam
