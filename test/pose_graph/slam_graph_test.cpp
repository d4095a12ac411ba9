// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/slam_graph.h"

#include <gtest/gtest.h>

#include "graph_fixtures.h"

namespace revisit_slam {
namespace {

constexpr std::uint32_t kNodes = 60;

/// A straight drive of 1 m a scan that the odometry bends to the left.
Pose bentPose(std::uint32_t i) {
  Pose T;
  const Pose step{expSO3({0.0, 0.0, 0.01}), {1.0, 0.0, 0.0}};
  for (std::uint32_t k = 0; k < i; ++k) T = T * step;
  return T;
}

SlamGraph bentDrive() {
  SlamGraph graph({});
  for (std::uint32_t i = 0; i < kNodes; ++i)
    graph.add({ScanId{i}, Stamp{i}, bentPose(i), correlatedInformation(0.05, 0.03)});
  return graph;
}

/// As a registration that knows the truth would have it: scan `to` straight ahead of scan `from`.
LoopConstraint straight(std::uint32_t from, std::uint32_t to, double aside = 0.0) {
  LoopConstraint loop;
  loop.constraint = {ScanId{from},
                     ScanId{to},
                     {Eigen::Quaterniond::Identity(), {1.0 * to - from, aside, 0.0}},
                     correlatedInformation(0.01, 0.0005)};
  return loop;
}

double offLine(const SlamGraph& graph, std::uint32_t scan) {
  return std::abs(graph.pose(ScanId{scan}).translation.y());
}

TEST(SlamGraph, StandsAsTheOdometryHasItWithoutLoops) {
  SlamGraph graph = bentDrive();
  EXPECT_TRUE(graph.optimise(ScanId{kNodes - 1}, {}));
  for (std::uint32_t i = 0; i < kNodes; ++i)
    EXPECT_LT((graph.pose(ScanId{i}).translation - bentPose(i).translation).norm(), 1e-9);
}

TEST(SlamGraph, LoopsCorrectAndLaterScansAreCarriedAlong) {
  SlamGraph graph = bentDrive();
  ASSERT_TRUE(graph.optimise(ScanId{39}, {straight(0, 39)}));
  EXPECT_LT(offLine(graph, 39), 0.2);
  EXPECT_GT(graph.movedEnd(), 5.0);
  const Pose T_39_50 = graph.pose(ScanId{39}).inverse() * graph.pose(ScanId{50});
  EXPECT_LT(((bentPose(39).inverse() * bentPose(50)).translation - T_39_50.translation).norm(),
            1e-9);
  ASSERT_EQ(graph.loops().size(), 1u);
  EXPECT_GT(graph.loops()[0].chi2_before, 100.0 * graph.loops()[0].chi2_after);
  EXPECT_GT(graph.loops()[0].weight, 0.5);
}

TEST(SlamGraph, ALoopAgainstManyIsKeptButLeftOut) {
  SlamGraph graph = bentDrive();
  ASSERT_TRUE(graph.optimise(ScanId{50}, {straight(0, 50), straight(2, 48), straight(5, 45)}));
  const std::vector<Pose> before = graph.poses();
  EXPECT_FALSE(graph.optimise(ScanId{55}, {straight(1, 47, 30.0)}));
  ASSERT_EQ(graph.loops().size(), 4u);
  EXPECT_EQ(graph.loops()[3].state, LoopState::rejected);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(graph.poses()[i].translation, before[i].translation);
  EXPECT_TRUE(graph.optimise(ScanId{59}, {straight(10, 59)}));  // and the graph goes on
  EXPECT_EQ(graph.graph().factors().size(), kNodes - 1 + 4u);
}

/// Two wrong loops, which agree, were closed before the first right one.
SlamGraph misledDrive() {
  SlamGraph graph = bentDrive();
  EXPECT_TRUE(graph.optimise(ScanId{50}, {straight(1, 47, 15.0), straight(3, 49, 15.0)}));
  EXPECT_FALSE(graph.optimise(ScanId{51}, {straight(5, 45)}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::rejected);
  return graph;
}

TEST(SlamGraph, ARejectedLoopIsAcceptedOnceOthersConfirmIt) {
  SlamGraph graph = misledDrive();
  ASSERT_TRUE(graph.optimise(ScanId{55}, {straight(0, 50), straight(2, 48), straight(4, 46)}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::active);
  EXPECT_GT(graph.loops()[2].weight, 0.5);
  EXPECT_LT(graph.loops()[0].weight, 0.1);
  EXPECT_LT(offLine(graph, 50), 0.2);
  EXPECT_GT(graph.movedEnd(), 5.0);
}

TEST(SlamGraph, ARejectedLoopIsAcceptedOnceThoseAgainstItAreDisabled) {
  SlamGraph graph = misledDrive();
  ASSERT_TRUE(graph.optimise(ScanId{51}, {}));  // nothing has changed
  EXPECT_EQ(graph.loops()[2].state, LoopState::rejected);
  EXPECT_TRUE(graph.disable(LoopId{0}));
  EXPECT_TRUE(graph.disable(LoopId{1}));
  ASSERT_TRUE(graph.optimise(ScanId{51}, {}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::active);
  const Pose T_5_45 = graph.pose(ScanId{5}).inverse() * graph.pose(ScanId{45});
  EXPECT_LT(std::abs(T_5_45.translation.y()), 0.2);
}

TEST(SlamGraph, ADisabledLoopIsNotTriedAgain) {
  SlamGraph graph = misledDrive();
  EXPECT_TRUE(graph.disable(LoopId{2}));
  ASSERT_TRUE(graph.optimise(ScanId{55}, {straight(0, 50), straight(2, 48), straight(4, 46)}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::disabled);
}

TEST(SlamGraph, ARejectedLoopWhoseSubmapsWereRegisteredAnewIsNotTriedAgain) {
  SlamGraph graph = misledDrive();
  ASSERT_TRUE(graph.optimise(ScanId{55},
                             {straight(0, 50), straight(2, 48), straight(4, 46), straight(5, 45)}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::rejected);
  EXPECT_EQ(graph.loops()[6].state, LoopState::active);
}

TEST(SlamGraph, OfTwoRegistrationsOfTheSameSubmapsOneCounts) {
  SlamGraph graph = misledDrive();
  EXPECT_FALSE(graph.optimise(ScanId{52}, {straight(5, 45)}));  // rejected likewise
  EXPECT_TRUE(graph.disable(LoopId{0}));
  EXPECT_TRUE(graph.disable(LoopId{1}));
  ASSERT_TRUE(graph.optimise(ScanId{53}, {}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::active);
  EXPECT_EQ(graph.loops()[3].state, LoopState::rejected);
}

TEST(SlamGraph, RejectedLoopsAreTriedAsTheyCame) {
  SlamGraph graph = misledDrive();
  EXPECT_FALSE(graph.optimise(ScanId{52}, {straight(6, 44, 90.0)}));  // wrong in another way
  ASSERT_TRUE(graph.optimise(ScanId{55}, {straight(0, 50), straight(2, 48), straight(4, 46)}));
  EXPECT_EQ(graph.loops()[2].state, LoopState::active);
  EXPECT_EQ(graph.loops()[3].state, LoopState::rejected);
}

TEST(SlamGraph, NumbersThatAreNotFiniteLeaveTheLastGoodPoses) {
  SlamGraph graph = bentDrive();
  ASSERT_TRUE(graph.optimise(ScanId{50}, {straight(0, 50)}));
  const Pose before = graph.pose(ScanId{50});
  LoopConstraint broken = straight(0, 51);
  broken.constraint.T_from_to.translation.x() = std::nan("");
  EXPECT_FALSE(graph.optimise(ScanId{55}, {broken}));
  EXPECT_EQ(graph.lastSolution().outcome, SolveOutcome::failed);
  EXPECT_EQ(graph.pose(ScanId{50}).translation, before.translation);
}

TEST(SlamGraph, ADisabledLoopLeavesNothingBehind) {
  SlamGraph graph = bentDrive();
  ASSERT_TRUE(graph.optimise(ScanId{50}, {straight(0, 50)}));
  EXPECT_TRUE(graph.disable(LoopId{0}));
  EXPECT_FALSE(graph.disable(LoopId{0}));
  EXPECT_FALSE(graph.disable(LoopId{7}));
  ASSERT_TRUE(graph.optimise(ScanId{50}, {}));
  for (std::uint32_t i = 0; i < kNodes; ++i)
    EXPECT_LT((graph.pose(ScanId{i}).translation - bentPose(i).translation).norm(), 1e-9);
}

/// The drive twice, as sessions 0 and 1, each in its own odometry frame.
SlamGraph bentDrives() {
  SlamGraph graph = bentDrive();
  for (std::uint32_t i = 0; i < kNodes; ++i)
    graph.add({ScanId{i, SessionId{1}}, Stamp{i}, bentPose(i), correlatedInformation(0.05, 0.03)});
  return graph;
}

/// Scan `to` of session 1 is 5 m to the left of scan `from` of session 0, and turned.
LoopConstraint across(std::uint32_t from, std::uint32_t to) {
  LoopConstraint loop = straight(from, to);
  loop.constraint.to.session = loop.source.session = SessionId{1};
  loop.constraint.T_from_to = {expSO3({0.0, 0.0, 0.5}), {0.0, 5.0, 0.0}};
  return loop;
}

TEST(SlamGraph, ASessionBeginsAMapOfItsOwn) {
  SlamGraph graph = bentDrive();
  graph.optimise(ScanId{39}, {straight(0, 39)});
  const Pose last = graph.pose(ScanId{kNodes - 1});
  graph.add({ScanId{0, SessionId{1}}, Stamp{}, bentPose(3), Matrix6::Identity()});
  EXPECT_EQ(graph.pose(ScanId{kNodes - 1}).translation, last.translation);
  EXPECT_EQ(graph.pose(ScanId{0, SessionId{1}}).translation, bentPose(3).translation);
  EXPECT_EQ(bentDrives().graph().factors().size(), 2u * (kNodes - 1));
}

TEST(SlamGraph, LoopsBringTheLaterSessionIntoTheMapOfTheEarlierOne) {
  SlamGraph graph = bentDrives();
  const ScanId end{kNodes - 1, SessionId{1}};
  ASSERT_TRUE(graph.optimise(end, {across(20, 30)}));
  const Pose T_from_to = graph.pose(ScanId{20}).inverse() * graph.pose(ScanId{30, SessionId{1}});
  EXPECT_LT((T_from_to.translation - Eigen::Vector3d(0.0, 5.0, 0.0)).norm(), 1e-6);
  EXPECT_EQ(graph.pose(ScanId{0}).translation, bentPose(0).translation);
  graph.add({ScanId{kNodes, SessionId{1}}, Stamp{}, bentPose(kNodes), Matrix6::Identity()});
  const Pose step = graph.pose(end).inverse() * graph.pose(ScanId{kNodes, SessionId{1}});
  EXPECT_LT((step.translation - Eigen::Vector3d(1.0, 0.0, 0.0)).norm(), 1e-6);
}

TEST(SlamGraph, LoopsThatAreRejectedLeaveTheSessionWhereItWas) {
  SlamGraph graph = bentDrives();
  LoopConstraint loop = across(20, 30);
  loop.constraint.information(0, 0) = std::nan("");
  EXPECT_FALSE(graph.optimise(ScanId{kNodes - 1, SessionId{1}}, {loop}));
  EXPECT_EQ(graph.pose(ScanId{7, SessionId{1}}).translation, bentPose(7).translation);
}

TEST(SlamGraph, GoesOnWithWhatWasOptimisedBefore) {
  SlamGraph before = bentDrive();
  before.optimise(ScanId{kNodes - 1}, {straight(0, kNodes - 1)});
  SlamGraph graph({});
  graph.addOptimised(before.nodes(), before.poses(), before.loops());
  ASSERT_EQ(graph.loops().size(), 1u);
  EXPECT_EQ(graph.loops()[0].weight, before.loops()[0].weight);
  EXPECT_EQ(graph.pose(ScanId{30}).translation, before.pose(ScanId{30}).translation);
  for (SlamGraph* either : {&before, &graph})
    either->add({ScanId{kNodes}, Stamp{}, bentPose(kNodes), correlatedInformation(0.05, 0.03)});
  EXPECT_LT(
      (graph.pose(ScanId{kNodes}).translation - before.pose(ScanId{kNodes}).translation).norm(),
      1e-9);
}

/// Of a wrong loop that is left out nothing stays, however certain of it the graph was.
TEST(SlamGraph, RightLoopsComeBackWhenTheWrongOneIsDisabled) {
  SlamGraph graph = bentDrive();
  LoopConstraint wrong = straight(0, 50, 25.0);
  wrong.constraint.information *= 1e4;
  ASSERT_TRUE(graph.optimise(ScanId{50}, {wrong}));
  graph.optimise(ScanId{55}, {straight(0, 55), straight(2, 53), straight(5, 50)});
  EXPECT_GT(offLine(graph, 50), 5.0);
  EXPECT_TRUE(graph.disable(LoopId{0}));
  ASSERT_TRUE(graph.optimise(ScanId{55}, {}));
  EXPECT_LT(offLine(graph, 50), 0.5);
  for (std::size_t i = 1; i < graph.loops().size(); ++i) {
    EXPECT_EQ(graph.loops()[i].state, LoopState::active) << i;
    EXPECT_GT(graph.loops()[i].weight, 0.5) << i;
  }
}

/// Bends of a drive that goes on from a straightened one, tied to it at both ends and the middle.
SlamGraph drivesTiedTo(const SlamGraph& before, bool is_frozen) {
  SlamGraph graph({});
  graph.addOptimised(before.nodes(), before.poses(), before.loops());
  if (is_frozen) graph.freezeMap();
  for (std::uint32_t i = 0; i < kNodes; ++i)
    graph.add({ScanId{i, SessionId{1}}, Stamp{i}, bentPose(i), correlatedInformation(0.05, 0.03)});
  std::vector<LoopConstraint> ties;
  for (const std::uint32_t i : {5u, 30u, 55u}) {
    LoopConstraint tie = straight(i, i, 1.0);
    tie.constraint.to.session = tie.source.session = SessionId{1};
    ties.push_back(tie);
  }
  EXPECT_TRUE(graph.optimise(ScanId{kNodes - 1, SessionId{1}}, ties));
  return graph;
}

TEST(SlamGraph, AFrozenMapStaysWhereItIsAndTheDriveFollows) {
  SlamGraph before = bentDrive();
  before.optimise(ScanId{kNodes - 1}, {straight(0, kNodes - 1)});
  const SlamGraph frozen = drivesTiedTo(before, true), free = drivesTiedTo(before, false);
  double moved = 0.0;
  for (std::uint32_t i = 0; i < kNodes; ++i) {
    EXPECT_EQ(frozen.pose(ScanId{i}).matrix(), before.pose(ScanId{i}).matrix()) << i;
    moved = std::max(moved, distanceBetween(free.pose(ScanId{i}), before.pose(ScanId{i})));
  }
  EXPECT_GT(moved, 1e-3);
  for (const std::uint32_t i : {5u, 30u, 55u}) {
    const Pose T = frozen.pose(ScanId{i}).inverse() * frozen.pose(ScanId{i, SessionId{1}});
    EXPECT_LT((T.translation - Eigen::Vector3d(0.0, 1.0, 0.0)).norm(), 0.2) << i;
  }
}

/// Nor where the loop that tied two sessions of the map is disabled, and the drive is tied to both.
TEST(SlamGraph, AFrozenMapDoesNotFallApart) {
  SlamGraph before = bentDrives();
  ASSERT_TRUE(before.optimise(ScanId{kNodes - 1, SessionId{1}}, {across(20, 30)}));
  SlamGraph graph({});
  graph.addOptimised(before.nodes(), before.poses(), before.loops());
  graph.freezeMap();
  ASSERT_TRUE(graph.disable(LoopId{0}));
  for (std::uint32_t i = 0; i < kNodes; ++i)
    graph.add({ScanId{i, SessionId{2}}, Stamp{i}, bentPose(i), correlatedInformation(0.05, 0.03)});
  const Pose held = graph.pose(ScanId{30, SessionId{1}});
  LoopConstraint first = straight(20, 20, 1.0), second = straight(30, 7);
  first.constraint.to.session = second.constraint.to.session = SessionId{2};
  second.constraint.from.session = SessionId{1};
  const Pose T_map_7 =
      graph.pose(ScanId{20}) * first.constraint.T_from_to * bentPose(20).inverse() * bentPose(7);
  const Pose aside{Eigen::Quaterniond::Identity(), {0.0, 0.1, 0.0}};
  second.constraint.T_from_to = held.inverse() * T_map_7 * aside;
  ASSERT_TRUE(graph.optimise(ScanId{kNodes - 1, SessionId{2}}, {first, second}));
  EXPECT_EQ(graph.pose(ScanId{30, SessionId{1}}).matrix(), held.matrix());
}

/// Loops of the map that its poses contradict cannot be overridden: nothing moves them.
TEST(SlamGraph, LoopsWithinAFrozenMapHaveNoVote) {
  const SlamGraph bent = bentDrive();
  std::vector<LoopEdge> loops;
  for (const std::uint32_t i : {0u, 2u, 4u}) {
    LoopEdge edge;
    edge.loop = straight(i, 50 + i);
    edge.weight = 1.0;
    loops.push_back(edge);
  }
  SlamGraph graph({});
  graph.addOptimised(bent.nodes(), bent.poses(), loops);
  graph.freezeMap();
  for (std::uint32_t i = 0; i < kNodes; ++i)
    graph.add({ScanId{i, SessionId{1}}, Stamp{i}, bentPose(i), correlatedInformation(0.05, 0.03)});
  LoopConstraint tie = straight(20, 20, 1.0);
  tie.constraint.to.session = tie.source.session = SessionId{1};
  EXPECT_TRUE(graph.optimise(ScanId{kNodes - 1, SessionId{1}}, {tie}));
}

TEST(SlamGraph, ASessionThatWasInNoMapIsNotFrozen) {
  SlamGraph graph = bentDrives();
  graph.freezeMap();
  ASSERT_TRUE(graph.optimise(ScanId{kNodes - 1, SessionId{1}}, {across(20, 30)}));
  EXPECT_EQ(graph.pose(ScanId{20}).matrix(), Pose(bentPose(20)).matrix());
  EXPECT_GT(distanceBetween(graph.pose(ScanId{30, SessionId{1}}), bentPose(30)), 1.0);
}

TEST(SlamGraph, RefusesAGapInTheScans) {
  SlamGraph graph = bentDrive();
  EXPECT_THROW(graph.add({ScanId{kNodes + 1}, {}, {}, Matrix6::Identity()}), std::invalid_argument);
}

}  // namespace
}  // namespace revisit_slam
