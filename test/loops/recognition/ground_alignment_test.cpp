// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/recognition/ground_alignment.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// Rough ground at z = 0 of the level frame with walls on it and some points below it.
Points roughGroundWithWalls(RandomNumbers& random) {
  Points points;
  for (double x = -60; x < 60; x += 0.5)
    for (double y = -40; y < 40; y += 0.5) {
      const bool is_roof = x > 20 && x < 45 && y > 5 && y < 30;  // hides the ground
      const double height = is_roof ? 8.0 : 0.1 * std::sin(0.4 * x) + random.gaussian(0.05);
      points.push_back(Eigen::Vector3d(x, y, height).cast<float>());
    }
  for (double x = -60; x < 60; x += 0.5)
    for (double z = 0; z < 10; z += 0.5) points.push_back(Eigen::Vector3d(x, 12, z).cast<float>());
  for (int i = 0; i < 200; ++i)
    points.push_back((random.inCube(30) - Eigen::Vector3d(0, 0, 35)).cast<float>());
  return points;
}

double yawOf(const Pose& T) {
  return std::atan2(T.rotationMatrix()(1, 0), T.rotationMatrix()(0, 0));
}

class Tilt : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(Tilt, IsTakenOutAndSoIsTheHeight) {
  RandomNumbers random(3);
  const auto [roll, pitch] = GetParam();
  const Pose T_true{expSO3({roll, 0, 0}) * expSO3({0, pitch, 0}), {0, 0, 2.3}};
  Points points_local;
  for (const auto& p : roughGroundWithWalls(random))
    points_local.push_back((T_true.inverse() * p.cast<double>()).cast<float>());

  const Pose T = levelOnGround(points_local);
  const Eigen::Vector3d up_true = T_true.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d up = T.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  EXPECT_LT(std::acos(std::min(1.0, up.dot(up_true))), 0.003);
  EXPECT_NEAR(T.translation.z(), T_true.translation.z(), 0.1) << "the lowest count";
  EXPECT_EQ(T.translation.head<2>(), Eigen::Vector2d::Zero());
  EXPECT_NEAR(T.rotation.z(), 0.0, 1e-9) << "the axis is horizontal";
  EXPECT_NEAR(yawOf(T), 0.0, 0.02) << "of second order in the tilt";
}

INSTANTIATE_TEST_SUITE_P(Tilts, Tilt,
                         ::testing::Values(std::pair(0.0, 0.0), std::pair(0.05, -0.08),
                                           std::pair(-0.2, 0.1), std::pair(0.1, 0.25)));

TEST(LevelOnGround, LeavesAsItIsWhatTellsNoPlane) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Points few{{0, 0, 3}, {1, 0, 3}};
  for (const Points& points : {Points{}, few, Points(100, {nan, 0, 0}), Points(100, {1e30f, 0, 0}),
                               Points(100, {5, 5, 5})}) {
    const Pose T = levelOnGround(points);
    EXPECT_EQ(T.translation, Eigen::Vector3d::Zero());
    EXPECT_EQ(T.angle(), 0.0);
  }
}

TEST(LevelOnGround, DoesNotRollAboutANarrowStrip) {
  RandomNumbers random(1);
  Points strip;
  for (double x = 0; x < 100; x += 0.5)
    strip.push_back(Eigen::Vector3d(x, 0.3, random.gaussian(0.03)).cast<float>());
  EXPECT_LT(levelOnGround(strip).angle(), 0.02);
}

}  // namespace
}  // namespace revisit_slam
