// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/chain_piece.h"

#include <gtest/gtest.h>

#include "pose_graph/graph_fixtures.h"
#include "revisit_slam/pose_graph/graph_cost.h"
#include "revisit_slam/pose_graph/minimize.h"

namespace revisit_slam {
namespace {

/// A curve of a few metres with differing, correlated links.
std::vector<RelativePoseFactor> someChain(std::uint32_t length) {
  RandomNumbers random(4);
  std::vector<RelativePoseFactor> chain;
  for (std::uint32_t i = 0; i < length; ++i) {
    const Pose step{expSO3(random.tangent(0, 0.3).tail<3>()), {1.0, random.uniform(-0.2, 0.2), 0}};
    chain.push_back({{NodeId{i}, NodeId{i + 1}},
                     step,
                     correlatedInformation(random.uniform(0.01, 0.1), random.uniform(1e-3, 1e-2))});
  }
  return chain;
}

ChainPiece pieceOf(const std::vector<RelativePoseFactor>& chain) {
  ChainPiece piece;
  for (const RelativePoseFactor& link : chain) piece.push_back(&link);
  return piece;
}

TEST(ChainPiece, ComposesAsTheChainMinimisedWithItsEndHeld) {
  const std::vector<RelativePoseFactor> chain = someChain(6);
  const ChainPiece piece = pieceOf(chain);
  const RelativePoseFactor whole = composed(piece);
  EXPECT_EQ(whole.from(), NodeId{0});
  EXPECT_EQ(whole.to(), NodeId{6});
  RandomNumbers random(5);
  for (int trial = 0; trial < 5; ++trial) {
    const Tangent deviation = 1e-4 * random.tangent(1.0, 1.0);
    const Pose T_map_last = boxplus(whole.T_from_to, deviation);
    PoseGraph graph;
    graph.addNode({});
    for (const Pose& T : bentPiece(piece, {}, T_map_last)) graph.addNode(T);
    graph.addNode(T_map_last);
    for (const RelativePoseFactor& link : chain) graph.addFactor(link);
    const RelativePoseFactor held{{NodeId{0}, NodeId{6}}, T_map_last, 1e16 * Matrix6::Identity()};
    graph.addFactor(held);
    const Minimum minimum = minimize(graph, graph.poses(), {50, 1e-12});
    const double least = graphCost(graph, minimum.poses);
    EXPECT_NEAR(0.5 * deviation.dot(whole.information * deviation), least, 1e-3 * least);
    EXPECT_NEAR(graphCost(graph, graph.poses()), least, 1e-3 * least);  // as it was bent
  }
}

TEST(ChainPiece, UndisturbedChainIsDeadReckoning) {
  const std::vector<RelativePoseFactor> chain = someChain(20);
  const ChainPiece piece = pieceOf(chain);
  RandomNumbers random(6);
  Pose T = random.pose(100.0);
  const std::vector<Pose> inner = bentPiece(piece, T, T * composed(piece).T_from_to);
  ASSERT_EQ(inner.size(), 19u);
  for (std::size_t k = 0; k < inner.size(); ++k) {
    T = T * chain[k].T_from_to;
    EXPECT_LT(distanceBetween(inner[k], T), 1e-10);
  }
}

TEST(ChainPiece, OfOneRelativePoseFactorIsThatRelativePoseFactor) {
  std::vector<RelativePoseFactor> chain = someChain(1);
  chain[0].information.setZero();
  const RelativePoseFactor whole = composed(pieceOf(chain));
  EXPECT_EQ(whole.information, chain[0].information);
  EXPECT_TRUE(bentPiece(pieceOf(chain), {}, {}).empty());
}

TEST(ChainPiece, UnknownDirectionsStayFinite) {
  std::vector<RelativePoseFactor> chain = someChain(3);
  chain[0].information.setZero();
  chain[1].information.bottomRightCorner<3, 3>().setZero();
  chain[1].information.topRightCorner<3, 3>().setZero();
  chain[1].information.bottomLeftCorner<3, 3>().setZero();
  EXPECT_TRUE(composed(pieceOf(chain)).information.allFinite());
  for (const Pose& T : bentPiece(pieceOf(chain), {}, {Eigen::Quaterniond::Identity(), {9, 9, 9}}))
    EXPECT_TRUE(T.matrix().allFinite());
}

}  // namespace
}  // namespace revisit_slam
