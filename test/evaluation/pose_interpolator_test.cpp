// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/pose_interpolator.h"

#include <gtest/gtest.h>

#include "evaluation/evaluation_fixtures.h"

namespace revisit_slam {
namespace {

using Kind = PoseAnswer::Kind;

const Pose kHere{Eigen::Quaterniond::Identity(), {0, 0, 0}};
const Pose kThere{expSO3({0, 0, 1.0}), {4, -2, 1}};

Stamp at(double seconds) {
  return Stamp::fromSeconds(seconds);
}

TEST(PoseInterpolator, InterpolatesPositionsLinearlyAndRotationsAtAConstantRate) {
  const PoseAnswer quarter = PoseInterpolator({{at(1.0), kHere}, {at(1.4), kThere}}).at(at(1.1));
  ASSERT_EQ(quarter.kind, Kind::found);
  EXPECT_LT((quarter.T_world_base.translation - Eigen::Vector3d(1, -0.5, 0.25)).norm(), 1e-12);
  EXPECT_LT((logSO3(quarter.T_world_base.rotation) - Eigen::Vector3d(0, 0, 0.25)).norm(), 1e-12);
}

TEST(PoseInterpolator, HasNoPoseBeyondItsEndsButForRounding) {
  const PoseInterpolator poses({{at(1.0), kHere}, {at(1.4), kThere}});
  EXPECT_EQ(poses.at(at(0.9985)).kind, Kind::outside);
  EXPECT_EQ(poses.at(at(1.4015)).kind, Kind::outside);
  EXPECT_EQ(poses.at(at(0.9995)).kind, Kind::found);
  EXPECT_EQ(poses.at(at(1.4005)).T_world_base.translation, kThere.translation);
  EXPECT_EQ(PoseInterpolator(Trajectory{}).at(at(1.0)).kind, Kind::outside);
}

TEST(PoseInterpolator, HasNoPoseInALongGapButAtItsEnds) {
  const PoseInterpolator poses({{at(1.0), kHere}, {at(2.5), kThere}}, 1.0);
  EXPECT_EQ(poses.at(at(1.2)).kind, Kind::in_gap);
  EXPECT_EQ(poses.at(at(1.0)).kind, Kind::found);
  EXPECT_EQ(poses.at(at(2.5)).kind, Kind::found);
}

TEST(PoseInterpolator, SortsAndKeepsTheFirstOfEqualStamps) {
  const PoseInterpolator poses({{at(2.0), kThere}, {at(1.5), kHere}, {at(2.0), kHere}});
  ASSERT_EQ(poses.poses().size(), 2u);
  EXPECT_EQ(poses.at(at(2.0)).T_world_base.translation, kThere.translation);
}

}  // namespace
}  // namespace revisit_slam
