// SPDX-License-Identifier: MIT
#include "revisit_slam/types/pose.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).norm();
}

TEST(Pose, IsAGroup) {
  RandomNumbers random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose a = random.pose(10.0), b = random.pose(10.0), c = random.pose(10.0);
    EXPECT_LT(difference((a * b) * c, a * (b * c)), 1e-12);
    EXPECT_LT(difference(a * Pose::identity(), a), 1e-14);
    EXPECT_LT(difference(Pose::identity() * a, a), 1e-14);
    EXPECT_LT(difference(a * a.inverse(), {}), 1e-13);
    EXPECT_LT(difference(a.inverse() * a, {}), 1e-13);
  }
}

TEST(Pose, ComposesAndMapsPointsAsItsMatrixDoes) {
  RandomNumbers random(2);
  for (int i = 0; i < 100; ++i) {
    const Pose a = random.pose(10.0), b = random.pose(10.0);
    const Eigen::Vector3d p = random.inCube(10.0);
    EXPECT_LT((a.matrix() * b.matrix() - (a * b).matrix()).norm(), 1e-12);
    EXPECT_LT(((a.matrix() * p.homogeneous()).head<3>() - a * p).norm(), 1e-12);
    EXPECT_LT((a * b * p - a * (b * p)).norm(), 1e-12);
    EXPECT_LT(difference(Pose::fromMatrix(a.matrix()), a), 1e-12);
  }
}

TEST(Pose, RotationStaysAUnitQuaternionUnderManyCompositions) {
  RandomNumbers random(3);
  Pose T = random.pose(0.0);
  T.rotation.coeffs() *= 1.0 + 1e-9;
  for (int i = 0; i < 1000; ++i) {
    T = T * random.pose(0.0);
    ASSERT_NEAR(T.rotation.norm(), 1.0, 1e-15);
  }
}

TEST(Pose, AngleLiesBetweenZeroAndPiForBothSignsOfTheQuaternion) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 3).normalized();
  for (const double angle : {0.0, 1e-9, 1e-3, 1.0, 3.0, 3.1415, -0.5, 3.5, 6.0}) {
    Pose T{Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), Eigen::Vector3d::Ones()};
    const double expected = std::min(std::abs(angle), 2.0 * M_PI - std::abs(angle));
    EXPECT_NEAR(T.angle(), expected, 1e-15);
    T.rotation.coeffs() *= -1.0;
    EXPECT_NEAR(T.angle(), expected, 1e-15);
  }
}

}  // namespace
}  // namespace revisit_slam
