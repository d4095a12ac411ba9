// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/acceptance/loop_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

/// Submaps of 100 m each.
std::vector<std::shared_ptr<Submap>> submaps(unsigned count) {
  std::vector<std::shared_ptr<Submap>> submaps;
  for (unsigned i = 0; i < count; ++i) {
    submaps.push_back(std::make_shared<Submap>());
    submaps.back()->id = {i};
    submaps.back()->travelled_begin = 100.0 * i;
  }
  return submaps;
}

double driftBetween(const std::vector<std::shared_ptr<Submap>>& submaps, unsigned a, unsigned b,
                    const std::vector<LoopEdge>& loops = {}) {
  const GraphDrift drift({submaps.begin(), submaps.end()}, loops, {});
  return drift.from({a})[b].plane;
}

TEST(GraphDrift, GrowsWithTheWayInEitherDirection) {
  EXPECT_NEAR(driftBetween(submaps(5), 4, 0), 0.3 + 0.01 * 400, 1e-12);
  EXPECT_NEAR(driftBetween(submaps(5), 0, 4), 0.3 + 0.01 * 400, 1e-12);
  EXPECT_NEAR(driftBetween(submaps(5), 2, 2), 0.3, 1e-12);
}

TEST(GraphDrift, GrowsFasterWhereTheOdometryIsUnsure) {
  auto drive = submaps(3);
  drive[2]->unsure_begin = {60.0, 0.0, 5.0};
  EXPECT_NEAR(driftBetween(drive, 1, 2), 0.3 + 0.01 * 100 + 0.05 * 60 + 5.0, 1e-12);
  EXPECT_NEAR(driftBetween(drive, 0, 1), 0.3 + 0.01 * 100, 1e-12);
}

/// Along a ramp without things beside it the floor still holds the height.
TEST(GraphDrift, InHeightGrowsFasterOnlyWhereTheHeightIsUnsure) {
  auto drive = submaps(3);
  drive[1]->unsure_begin = drive[2]->unsure_begin = {60.0, 0.0, 0.0};
  drive[2]->unsure_begin.weak_height = 40.0;
  const GraphDrift drift({drive.begin(), drive.end()}, {}, {});
  EXPECT_NEAR(drift.between({0}, {1}).height, 0.3 * (0.3 + 0.01 * 100), 1e-12);
  EXPECT_NEAR(drift.between({1}, {2}).height, 0.3 * (0.3 + 0.01 * 100) + 0.05 * 40, 1e-12);
  EXPECT_NEAR(drift.between({0}, {2}).height, 0.3 * (0.3 + 0.01 * 200) + 0.05 * 40, 1e-12);
}

TEST(GraphDrift, TakesTheShortWayOverLoopsThatTheGraphHasTaken) {
  LoopEdge edge;
  edge.loop.target = {0};
  edge.loop.source = {7};
  EXPECT_NEAR(driftBetween(submaps(10), 9, 1, {edge}), 0.3 + 0.3 + 0.01 * 300, 1e-12);
  edge.state = LoopState::rejected;
  EXPECT_NEAR(driftBetween(submaps(10), 9, 1, {edge}), 0.3 + 0.01 * 800, 1e-12);
}

TEST(GraphDrift, OfAWayThatADamagedMapHasBackwardsIsThatOfNoWay) {
  for (const double travelled : {-50.0, std::nan("")}) {
    auto drive = submaps(3);
    drive[1]->travelled_begin = travelled;
    EXPECT_NEAR(driftBetween(drive, 0, 1), 0.3, 1e-12);
  }
}

TEST(LoopPrior, MeasuresInThePlaneInHeightAndInRotation) {
  const Pose expected{expSO3({0, 0, 0.4}), {10, 0, 0}};
  const LoopPrior prior{expected, {2.0, 0.6}};
  EXPECT_NEAR(prior.deviation(expected, {}), 0.0, 1e-9);
  EXPECT_NEAR(prior.deviation({expected.rotation, {10, 6, 0}}, {}), 3.0, 1e-9);
  EXPECT_NEAR(prior.deviation({expected.rotation, {10, 0, -3.0}}, {}), 3.0 / 0.6, 1e-9);
  const LoopPrior near{expected, {0.4, 0.1}};
  EXPECT_NEAR(near.deviation({expected.rotation, {10, 0, -0.3}}, {}), 1.0, 1e-9);
  const Pose turned{expSO3({0, 0, 0.4 + 6.0 * M_PI / 180.0}), {10, 0, 0}};
  EXPECT_NEAR(prior.deviation(turned, {}), 3.0, 1e-9);
}

TEST(LoopPrior, WithoutKnowledgeNothingDeviates) {
  EXPECT_EQ(LoopPrior().deviation({expSO3({0, 0, 3.0}), {100, 0, 0}}, {}), 0.0);
}

}  // namespace
}  // namespace revisit_slam
