// SPDX-License-Identifier: MIT
#include "revisit_slam/io/g2o.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

const std::string kIdentity = "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1";
const std::string kEdge = "EDGE_SE3:QUAT 10 11 1 0 0 0 0 0 1 " + kIdentity + "\n";
const std::string kVertices =
    "VERTEX_SE3:QUAT 11 1 0 0 0 0 0 2\n# a comment\n\nVERTEX_SE3:QUAT 10 0 0 0 0 0 0 1\nFIX 10\n";

std::string messageOfReading(const std::string& text) {
  const TemporaryFolder folder;
  try {
    readG2o(folder.with("a.g2o", text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

Matrix6 someInformation(RandomNumbers& random) {
  Matrix6 A;
  for (int i = 0; i < 36; ++i) A(i / 6, i % 6) = random.uniform(-1.0, 1.0);
  return A * A.transpose() + Matrix6::Identity();
}

TEST(G2o, ReadsNodesInTheOrderOfTheirIds) {
  const TemporaryFolder folder;
  const G2oGraph read = readG2o(folder.with("a.g2o", kEdge + kVertices));
  EXPECT_EQ(read.ids, (std::vector<std::uint64_t>{10, 11}));
  EXPECT_EQ(read.graph.poses()[1].translation.x(), 1.0);
  EXPECT_EQ(read.graph.poses()[1].rotation.w(), 1.0);  // made a unit quaternion
  EXPECT_TRUE(read.graph.isHeld(NodeId{0}));
  EXPECT_FALSE(read.graph.isHeld(NodeId{1}));
  ASSERT_EQ(read.graph.factors().size(), 1u);
  EXPECT_EQ(read.graph.factors()[0].nodes().begin()[1], NodeId{1});
}

TEST(G2o, EdgesOtherThanToTheNextNodeAreLoops) {
  const TemporaryFolder folder;
  const std::string back = "EDGE_SE3:QUAT 11 10 -1 0 0 0 0 0 1 " + kIdentity + "\n";
  const RobustKernel kernel{KernelType::huber, 3.0};
  const G2oGraph read = readG2o(folder.with("a.g2o", kVertices + back + kEdge), kernel);
  ASSERT_EQ(read.graph.factors().size(), 2u);  // odometry first
  EXPECT_EQ(read.graph.factors()[0].kernel.type, KernelType::none);
  EXPECT_EQ(read.graph.factors()[1].kernel.type, KernelType::huber);
  EXPECT_EQ(read.graph.factors()[1].kernel.scale, 3.0);
  EXPECT_EQ(*read.graph.factors()[1].nodes().begin(), NodeId{1});
}

TEST(G2o, WhatIsWrittenReadsBackTheSame) {
  RandomNumbers random(1);
  G2oGraph written;
  written.ids = {3, 7, 8646911284551352320u};
  for (int i = 0; i < 3; ++i) written.graph.addNode(random.pose(1e4));
  for (const auto& nodes : {std::array{NodeId{0}, NodeId{1}}, std::array{NodeId{2}, NodeId{0}}})
    written.graph.addFactor(RelativePoseFactor{nodes, random.pose(5), someInformation(random)});
  written.graph.addFactor(PositionFactor{{NodeId{2}}});  // no such lines
  for (const std::uint32_t i : {0u, 2u}) written.graph.hold(NodeId{i});
  const TemporaryFolder folder;
  writeG2o(folder.file("a.g2o"), written);
  const G2oGraph read = readG2o(folder.file("a.g2o"));
  EXPECT_EQ(read.ids, written.ids);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(read.graph.isHeld({i}), i != 1) << i;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(distanceBetween(read.graph.poses()[i], written.graph.poses()[i]), 1e-11);
  ASSERT_EQ(read.graph.factors().size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& a = std::get<RelativePoseFactor>(read.graph.factors()[i].measurement);
    const auto& b = std::get<RelativePoseFactor>(written.graph.factors()[i].measurement);
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_LT(distanceBetween(a.T_from_to, b.T_from_to), 1e-12);
    EXPECT_LT((a.information - b.information).norm(), 1e-12);
  }
}

TEST(G2o, ErrorsNameTheLine) {
  const auto expectAt = [](int line, const std::string& what, const std::string& text) {
    const std::string message = messageOfReading(text);
    EXPECT_NE(message.find("a.g2o, line " + std::to_string(line) + ": "), std::string::npos)
        << message;
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  expectAt(1, "unknown type 'VERTEX_SE2'", "VERTEX_SE2 0 1 2 3\n");
  expectAt(2, "a number is missing", "\nVERTEX_SE3:QUAT 0 1 2 3 0 0 0\n");
  expectAt(1, "not finite", "VERTEX_SE3:QUAT 0 1 2 nan 0 0 0 1\n");
  expectAt(1, "larger than 1e30", "VERTEX_SE3:QUAT 0 1 2 3 0 0 0 1e200\n");
  expectAt(1, "no length", "VERTEX_SE3:QUAT 0 1 2 3 0 0 0 0\n");
  expectAt(1, "'-1' is no id", "VERTEX_SE3:QUAT -1 1 2 3 0 0 0 1\n");
  expectAt(1, "too much at '9'", "VERTEX_SE3:QUAT 0 1 2 3 0 0 0 1 9\n");
  expectAt(6, "vertex 10 is there already", kVertices + "VERTEX_SE3:QUAT 10 0 0 0 0 0 0 1\n");
  expectAt(2, "there is no vertex 11", "VERTEX_SE3:QUAT 10 0 0 0 0 0 0 1\n" + kEdge);
  expectAt(6, "there is no vertex 12", kVertices + "FIX 10 12\n");
  expectAt(1, "'x' is no id", "FIX 10 x\n" + kVertices);
  expectAt(1, "itself", "EDGE_SE3:QUAT 10 10 1 0 0 0 0 0 1 " + kIdentity + "\n" + kVertices);
  expectAt(1, "negative eigenvalue",
           "EDGE_SE3:QUAT 10 11 1 0 0 0 0 0 1 -1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n");
  expectAt(1, "negative eigenvalue",
           "EDGE_SE3:QUAT 10 11 1 0 0 0 0 0 1 1 2 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n");
  expectAt(1, "a byte of no text", std::string(100, '\0'));
  expectAt(0, "there is no vertex", "");
  EXPECT_EQ(messageOfReading(kVertices + kEdge), "accepted");
  EXPECT_THROW(readG2o("/nowhere/a.g2o"), std::runtime_error);
}

/// The residual as g2o defines it, squared by the information of the file, must be ours where the
/// residual is small.
TEST(G2o, ConvertedInformationGivesTheSameChi2OfSmallResiduals) {
  RandomNumbers random(2);
  for (int i = 0; i < 20; ++i) {
    const Matrix6 L = someInformation(random);
    const RelativePoseFactor measured{
        {NodeId{0}, NodeId{1}}, random.pose(5), informationFromG2o(L)};
    const Pose T_i = random.pose(5);
    const Pose T_j = T_i * measured.T_from_to * exp(random.tangent(1e-4, 1e-4));
    const Pose E = measured.T_from_to.inverse() * (T_i.inverse() * T_j);
    Tangent e;
    e << E.translation, (E.rotation.w() < 0.0 ? -1.0 : 1.0) * E.rotation.vec();
    const double theirs = e.dot(L * e);
    EXPECT_NEAR((Factor{measured, {}}.chi2({T_i, T_j})), theirs, 1e-3 * theirs);
    PoseGraph graph;
    graph.addNode(T_i);
    graph.addNode(T_j);
    graph.addFactor(measured);
    EXPECT_NEAR(g2oChi2(graph, graph.poses()), theirs, 1e-9 * theirs);
    EXPECT_LT((informationToG2o(informationFromG2o(L)) - L).norm(), 1e-14 * L.norm());
  }
}

}  // namespace
}  // namespace revisit_slam
