// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/ring_spacing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr double kDegree = M_PI / 180.0;
const Pose kTurned{expSO3({0.3, -0.2, 1.0}), {1.0, 2.0, 0.5}};

Eigen::Vector3f at(double range, double azimuth, double elevation) {
  return (range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth), std::sin(elevation)))
      .cast<float>();
}

/// Of 16 rings, 2 degrees apart.
Points ringedPoints() {
  RandomNumbers random(1);
  Points points;
  for (int column = 0; column < 360; ++column)
    for (int ring = 0; ring < 16; ++ring)
      points.push_back(at(random.uniform(2, 60), column * kDegree, (2 * ring - 15) * kDegree));
  return points;
}

TEST(RingSpacing, IsTheAngleBetweenRings) {
  const RingSpacing rings(ringedPoints(), kTurned);
  for (const int elevation : {-15, -9, -1, 3, 15})
    EXPECT_NEAR(rings.gap(std::sin(elevation * kDegree)), 2.0 * kDegree, 0.12 * kDegree);
}

TEST(RingSpacing, MoreIsUnknownBetweenRingsTheFartherAPointIs) {
  const RingSpacing rings(ringedPoints(), kTurned);
  const auto across = [&](double range) {
    return rings.at(kTurned * at(range, 1.0, 5 * kDegree).cast<double>(), 0.2);
  };
  EXPECT_EQ(across(5.0).unknown, 0.0);
  const double spacing = 30.0 * 2.0 * kDegree;
  EXPECT_NEAR(across(30.0).unknown, 1.0 - 0.04 / (spacing * spacing), 0.01);
  EXPECT_GT(across(50.0).unknown, across(30.0).unknown);
}

TEST(RingSpacing, TheDirectionIsThatOfARisingElevation) {
  const AcrossRings across = RingSpacing(ringedPoints(), kTurned)
                                 .at(kTurned * at(40.0, 1.0, 5 * kDegree).cast<double>(), 0.2);
  const Eigen::Vector3d expected =
      kTurned.rotation *
      (at(1.0, 1.0, 5.01 * kDegree) - at(1.0, 1.0, 4.99 * kDegree)).cast<double>().normalized();
  EXPECT_GT(across.direction_base.dot(expected), 0.9999);
}

/// The sine of the elevation rounds to more than 1 there.
TEST(RingSpacing, NothingIsUnknownOnTheAxisOfTheSensor) {
  const RingSpacing rings(ringedPoints(), kTurned);
  for (int i = 1; i < 2000; ++i)
    for (const double z : {-0.01 * i, 0.01 * i})
      ASSERT_EQ(rings.at(kTurned * Eigen::Vector3d(0.0, 0.0, z), 0.2).unknown, 0.0) << z;
}

TEST(RingSpacing, ASensorWithoutRingsLeavesNothingUnknown) {
  RandomNumbers random(2);
  Points points;
  for (int i = 0; i < 20000; ++i)
    points.push_back(at(30.0, random.uniform(-1, 1), random.uniform(-0.6, 0.6)));
  const RingSpacing rings(points, kTurned);
  EXPECT_EQ(rings.gap(0.1), 0.0);
  EXPECT_EQ(rings.at({50.0, 0.0, 3.0}, 0.2).unknown, 0.0);
  EXPECT_EQ(RingSpacing({}, kTurned).at({50.0, 0.0, 3.0}, 0.2).unknown, 0.0);
  EXPECT_EQ(RingSpacing().at({50.0, 0.0, 3.0}, 0.2).unknown, 0.0);
}

}  // namespace
}  // namespace revisit_slam
