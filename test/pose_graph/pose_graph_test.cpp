// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/pose_graph.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/gauge.h"

namespace revisit_slam {
namespace {

Constraint between(std::uint32_t from, std::uint32_t to) {
  Constraint constraint;
  constraint.from = ScanId{from};
  constraint.to = ScanId{to};
  return constraint;
}

PoseGraph graphOf(int nodes) {
  RandomNumbers random(1);
  PoseGraph graph;
  for (int i = 0; i < nodes; ++i) graph.addNode(random.pose(10.0));
  return graph;
}

TEST(PoseGraph, CountsNodesAndLoops) {
  PoseGraph graph = graphOf(2);
  EXPECT_EQ(graph.addNode({}), ScanId{2});
  EXPECT_EQ(graph.addLoop(between(0, 2)), LoopId{0});
  EXPECT_EQ(graph.addLoop(between(2, 0)), LoopId{1});
}

TEST(PoseGraph, RefusesConstraintsOfUnknownNodes) {
  PoseGraph graph = graphOf(2);
  EXPECT_THROW(graph.addOdometry(between(1, 2)), std::invalid_argument);
  EXPECT_THROW(graph.addLoop(between(1, 1)), std::invalid_argument);
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

TEST(PoseGraph, EveryConnectedPartHasItsGauge) {
  PoseGraph graph = graphOf(7);
  graph.addOdometry(between(0, 1));
  graph.addOdometry(between(5, 4));
  graph.addLoop(between(2, 1));
  graph.addLoop(between(6, 5));
  EXPECT_EQ(gaugeNodes(graph), (std::vector<ScanId>{{0}, {3}, {4}}));
  EXPECT_TRUE(gaugeNodes(PoseGraph()).empty());
}

}  // namespace
}  // namespace revisit_slam
