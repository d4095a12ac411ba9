// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/pose_graph.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "pose_graph/graph_fixtures.h"

namespace revisit_slam {
namespace {

RelativePoseFactor between(std::uint32_t from, std::uint32_t to) {
  return {{NodeId{from}, NodeId{to}}, {}};
}

PoseGraph graphOf(int nodes) {
  RandomNumbers random(1);
  PoseGraph graph;
  for (int i = 0; i < nodes; ++i) graph.addNode(random.pose(10.0));
  return graph;
}

TEST(PoseGraph, CountsNodesAndFactors) {
  PoseGraph graph = graphOf(2);
  EXPECT_EQ(graph.addNode({}), NodeId{2});
  EXPECT_EQ(graph.addFactor(between(0, 2)), FactorId{0});
  EXPECT_EQ(graph.addFactor(PositionFactor{{NodeId{2}}}), FactorId{1});
}

TEST(PoseGraph, RefusesFactorsOfUnknownNodes) {
  PoseGraph graph = graphOf(2);
  EXPECT_THROW(graph.addFactor(between(1, 2)), std::invalid_argument);
  EXPECT_THROW(graph.addFactor(between(1, 1)), std::invalid_argument);
  EXPECT_THROW(graph.addFactor(PositionFactor{{NodeId{2}}}), std::invalid_argument);
  EXPECT_TRUE(graph.factors().empty());
}

TEST(PoseGraph, FactorsBetweenHeldNodesAreSettled) {
  PoseGraph graph = graphOf(3);
  for (const std::uint32_t to : {1u, 2u}) graph.addFactor(between(0, to));
  graph.hold(NodeId{0});
  graph.hold(NodeId{2});
  EXPECT_TRUE(graph.isHeld(NodeId{0}));
  EXPECT_FALSE(graph.isHeld(NodeId{1}));
  EXPECT_FALSE(graph.isSettled(graph.factors()[0]));
  EXPECT_TRUE(graph.isSettled(graph.factors()[1]));
  EXPECT_THROW(graph.hold(NodeId{3}), std::invalid_argument);
}

TEST(PoseGraph, LaterNodesMoveAlongWithACorrection) {
  PoseGraph graph = graphOf(5);
  const std::vector<Pose> before = graph.poses();
  const std::vector<Pose> solved = graphOf(3).poses();
  RandomNumbers random(8);
  std::vector<Pose> moved;
  for (const Pose& T : solved) moved.push_back(T * exp(random.tangent(1.0, 0.3)));
  graph.correct(moved);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(graph.poses()[i].matrix(), moved[i].matrix());
  for (std::uint32_t i = 2; i < 4; ++i)
    EXPECT_LT(distanceBetween(graph.poses()[i].inverse() * graph.poses()[i + 1],
                              before[i].inverse() * before[i + 1]),
              1e-12);
  EXPECT_THROW(graph.correct(graphOf(6).poses()), std::invalid_argument);
  EXPECT_THROW(graph.correct({}), std::invalid_argument);
}

}  // namespace
}  // namespace revisit_slam
