// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/loop_labels.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

Pose poseAt(double x, double y, double heading, double z = 0.0) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ())), {x, y, z}};
}

/// 41 scans, one a metre, from a place on with a heading; mapped without error.
Stretch straight(const Pose& T_world_start) {
  Stretch stretch;
  for (int i = 0; i <= 40; ++i) {
    stretch.T_map_scan.push_back(poseAt(i, 0.0, 0.0));
    stretch.T_world_scan.push_back(T_world_start * stretch.T_map_scan.back());
  }
  return stretch;
}

const Stretch kEarlier = straight(poseAt(0.0, 0.0, 0.0));

TEST(LoopLabels, PassesInOneLaneAreTheSame) {
  const LoopLabel label = labelOf(straight(poseAt(0.0, 1.0, 0.0)), kEarlier);
  EXPECT_EQ(label.kind(), PassKind::same);
  EXPECT_NEAR(label.sharedPath(), 40.0, 1e-9);
  EXPECT_NEAR(label.distance, 1.0, 1e-9);
  EXPECT_TRUE(label.isRevisit());
}

TEST(LoopLabels, PassesInTheNextLaneAreLateral) {
  EXPECT_EQ(labelOf(straight(poseAt(0.0, 5.0, 0.0)), kEarlier).kind(), PassKind::lateral);
}

TEST(LoopLabels, PassesTheOtherWayAreOpposite) {
  const LoopLabel label = labelOf(straight(poseAt(40.0, 3.0, M_PI)), kEarlier);
  EXPECT_EQ(label.kind(), PassKind::opposite);
  EXPECT_NEAR(label.sharedPath(), 40.0, 1e-9);
}

TEST(LoopLabels, CrossingIsARevisitThoughLittleIsShared) {
  const LoopLabel label = labelOf(straight(poseAt(20.0, -20.0, M_PI_2)), kEarlier);
  EXPECT_EQ(label.kind(), PassKind::crossing);
  EXPECT_NEAR(label.sharedPath(), 15.0, 1.01);
  EXPECT_TRUE(label.isRevisit());
}

TEST(LoopLabels, EndsThatTouchAreNoRevisit) {
  const LoopLabel label = labelOf(straight(poseAt(30.0, 0.0, 0.0)), kEarlier);
  EXPECT_LT(label.sharedPath(), 20.0);
  EXPECT_FALSE(label.isRevisit());
}

TEST(LoopLabels, AnotherLevelIsNoRevisit) {
  const LoopLabel label = labelOf(straight(poseAt(0.0, 0.0, 0.0, 3.0)), kEarlier);
  EXPECT_EQ(label.sharedPath(), 0.0);
  EXPECT_FALSE(label.isRevisit());
}

TEST(LoopLabels, TruthHasNoError) {
  const Pose T = poseAt(12.0, 3.0, 0.4);
  const LoopLabel label = labelOf(straight(T), kEarlier);
  EXPECT_LT(errorAtPlace(T, label).translation, 1e-9);
  EXPECT_LT(errorAtPlace(T, label).rotation, 1e-6);
  EXPECT_LT(errorAtKeypose(T, label).translation, 1e-9);
}

TEST(LoopLabels, ErrorsAreMetresAndDegrees) {
  const Pose T = poseAt(12.0, 3.0, 0.4);
  const LoopLabel label = labelOf(straight(T), kEarlier);
  const LoopError shifted = errorAtPlace(poseAt(0.3, 0.4, 0.0) * T, label);
  EXPECT_NEAR(shifted.translation, 0.5, 1e-9);
  EXPECT_LT(shifted.rotation, 1e-6);
  const LoopError turned = errorAtKeypose(T * poseAt(0.0, 0.0, M_PI / 180.0), label);
  EXPECT_LT(turned.translation, 1e-9);
  EXPECT_NEAR(turned.rotation, 1.0, 1e-6);
  EXPECT_TRUE(turned.within(0.3, 1.1));
  EXPECT_FALSE(turned.within(0.3, 0.9));
}

/// The second half of the target is bent against the first one, as drift does it: a closure there
/// is right when it fits there, though the keyposes say something else.
TEST(LoopLabels, DriftOnTheWayToThePlaceIsNoErrorOfTheClosure) {
  const Pose T_bend = poseAt(1.0, 0.5, 0.1);
  Stretch bent = kEarlier;
  for (int i = 15; i <= 40; ++i) bent.T_map_scan[i] = T_bend * bent.T_map_scan[i];
  const Pose T_target_source = poseAt(35.0, 0.0, 0.0);
  const LoopLabel label = labelOf(straight(T_target_source), bent);
  EXPECT_LT(errorAtPlace(T_bend * T_target_source, label).translation, 1e-6);
  EXPECT_GT(errorAtKeypose(T_bend * T_target_source, label).translation, 1.0);
}

}  // namespace
}  // namespace revisit_slam
