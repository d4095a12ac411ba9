// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/place_alignment.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr double kTurn = 2.8;

Eigen::Isometry2d truth(double turn = kTurn) {
  return Eigen::Translation2d(40, -25) * Eigen::Rotation2Dd(turn);
}

/// Pairs that agree, with noise, and some that do not; turns are wrapped as differences of angles
/// are.
std::vector<PointPair> somePairs(int right, int wrong, RandomNumbers& random, double turn = kTurn) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < right + wrong; ++i) {
    const Eigen::Vector2d source = random.inCube(200).head<2>();
    const Eigen::Vector2d noise = random.inCube(0.7).head<2>();
    if (i < right)
      pairs.push_back({source, truth(turn) * source + noise,
                       turn + random.uniform(-0.2, 0.2) - (i % 2) * 2 * M_PI});
    else
      pairs.push_back({source, random.inCube(200).head<2>(), random.uniform(-6, 6)});
  }
  return pairs;
}

void expectTruth(const PlanarAlignment& found, double turn = kTurn) {
  const Eigen::Isometry2d error = truth(turn).inverse() * found.T_target_source;
  EXPECT_LT(error.translation().norm(), 0.5);
  EXPECT_LT(std::abs(Eigen::Rotation2Dd(error.linear()).smallestAngle()), 0.005);
}

TEST(AlignPlanar, FindsTheFewThatAgree) {
  RandomNumbers random(2);
  const PlanarAlignment found = alignPlanar(somePairs(12, 100, random), {});
  EXPECT_EQ(found.inliers, 12);
  EXPECT_LT(found.rms, 1.0);
  expectTruth(found);
}

TEST(AlignPlanar, FindsThemAtEveryTurnWithEveryTolerance) {
  for (const double turn : {0.0, 0.1, 3.1, -3.1, -0.1})
    for (const double max_turn : {0.35, 2.0, 3.2}) {
      RandomNumbers random(2);
      PlanarAlignmentConfig config;
      config.max_turn = max_turn;
      config.samples = 1000000;
      const PlanarAlignment found = alignPlanar(somePairs(12, 60, random, turn), config);
      EXPECT_GE(found.inliers, 12) << turn << " " << max_turn;
      EXPECT_LE(found.inliers, 13);
      expectTruth(found, turn);
    }
}

TEST(AlignPlanar, AnyTurnMayBeAllowed) {
  RandomNumbers random(2);
  auto pairs = somePairs(12, 0, random);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].turn = kTurn + M_PI;
  EXPECT_EQ(alignPlanar(pairs, {}).inliers, 0);
  PlanarAlignmentConfig config;
  config.max_turn = 3.2;
  EXPECT_EQ(alignPlanar(pairs, config).inliers, 12);
}

TEST(AlignPlanar, FindsThemInAChoiceOfSamplesToo) {
  RandomNumbers random(2);
  const auto pairs = somePairs(80, 200, random);
  PlanarAlignmentConfig config;
  config.samples = 300;
  const PlanarAlignment found = alignPlanar(pairs, config);
  EXPECT_GE(found.inliers, 78);
  expectTruth(found);
  EXPECT_EQ(found.T_target_source.matrix(), alignPlanar(pairs, config).T_target_source.matrix());
}

TEST(AlignPlanar, IgnoresPairsTurnedOtherwise) {
  RandomNumbers random(2);
  auto pairs = somePairs(12, 0, random);
  for (std::size_t i = 0; i < 4; ++i) pairs[i].turn += 1.0;
  EXPECT_EQ(alignPlanar(pairs, {}).inliers, 8);
}

TEST(AlignPlanar, CountsACrowdOnce) {
  RandomNumbers random(2);
  auto pairs = somePairs(5, 0, random);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector2d near_first = pairs[0].source + random.inCube(1.5).head<2>();
    pairs.push_back({near_first, truth() * near_first, kTurn});
  }
  EXPECT_EQ(alignPlanar(pairs, {}).inliers, 5);
}

TEST(AlignPlanar, HasNothingToSayAboutTooFew) {
  RandomNumbers random(2);
  EXPECT_EQ(alignPlanar({}, {}).inliers, 0);
  EXPECT_EQ(alignPlanar(somePairs(1, 0, random), {}).inliers, 0);
  EXPECT_EQ(alignPlanar(std::vector<PointPair>(9, PointPair{{1, 1}, {2, 2}, 0}), {}).inliers, 0);
}

}  // namespace
}  // namespace revisit_slam
