// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/enu_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "revisit_slam/types/se3.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr double kScale = 2.0;

/// Along a line with a bend; errors of 1.5 m.
std::vector<PositionPair> pairsOf(const Pose& T_map_enu, int count, double spacing) {
  RandomNumbers random(4);
  std::vector<PositionPair> pairs;
  for (int i = 0; i < count; ++i) {
    PositionPair pair{
        {spacing * i, i > count / 2 ? 0.3 * spacing * (i - count / 2) : 0.0, 0.0}, {}, 1.5, 3.0};
    const Eigen::Vector3d noise(random.gaussian(1.5), random.gaussian(1.5), random.gaussian(3.0));
    pair.p_enu = T_map_enu.inverse() * pair.p_map + noise;
    pairs.push_back(pair);
  }
  return pairs;
}

double yawError(const Pose& a, const Pose& b) {
  return std::abs((a.inverse() * b).angle());
}

TEST(EnuAlignment, FindsAnyYawAndSaysHowSureItIs) {
  for (const double yaw : {0.0, 1.0, 3.0, -2.0}) {
    const Pose T_map_enu{expSO3({0.0, 0.0, yaw}), {100.0, -30.0, 7.0}};
    const auto aligned = alignToEnu(pairsOf(T_map_enu, 50, 5.0), kScale);
    ASSERT_TRUE(aligned);
    EXPECT_LT(yawError(aligned->T_map_enu, T_map_enu), 4.0 * aligned->yaw_deviation);
    EXPECT_LT(aligned->yaw_deviation, 0.005);
    EXPECT_LT((aligned->T_map_enu.translation - T_map_enu.translation).norm(), 3.0);
  }
}

TEST(EnuAlignment, JumpsOfAThirdOfThePositionsAreLeftOut) {
  const Pose T_map_enu{expSO3({0.0, 0.0, 2.0}), {10.0, 20.0, 0.0}};
  std::vector<PositionPair> pairs = pairsOf(T_map_enu, 60, 3.0);
  for (std::size_t i = 0; i < 20; ++i) pairs[i].p_enu += Eigen::Vector3d(0.0, 30.0, 0.0);
  const auto aligned = alignToEnu(pairs, kScale);
  ASSERT_TRUE(aligned);
  EXPECT_LT(yawError(aligned->T_map_enu, T_map_enu), 0.04);
}

TEST(EnuAlignment, APlaceHasNoYaw) {
  const Pose T_map_enu{expSO3({0.0, 0.0, 1.0}), {0.0, 0.0, 0.0}};
  EXPECT_FALSE(alignToEnu(pairsOf(T_map_enu, 2, 50.0), kScale));
  const auto aligned = alignToEnu(pairsOf(T_map_enu, 30, 0.05), kScale);
  EXPECT_TRUE(!aligned || aligned->yaw_deviation > 0.3);
}

}  // namespace
}  // namespace revisit_slam
