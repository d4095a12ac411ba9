// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/gravity_factor.h"

#include <gtest/gtest.h>

#include "revisit_slam/pose_graph/information_root.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

GravityFactor someFactor(RandomNumbers& random) {
  GravityFactor factor{{NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}},
                       random.inCube(1.0).normalized()};
  Eigen::Matrix3d A;
  for (int i = 0; i < 9; ++i) A(i / 3, i % 3) = random.uniform(-1.0, 1.0);
  factor.information = A * A.transpose() + 0.1 * Eigen::Matrix3d::Identity();
  return factor;
}

GravityFactor::Shape::Poses somePoses(RandomNumbers& random) {
  return {random.pose(50.0), random.pose(50.0), random.pose(50.0), random.pose(50.0)};
}

TEST(GravityFactor, JacobiansEqualDifferences) {
  RandomNumbers random(1);
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const GravityFactor factor = someFactor(random);
    const Eigen::Matrix3d U = informationRoot(factor.information);
    const auto T = somePoses(random);
    const auto at = factor.linearized(T, U);
    EXPECT_LT((at.residual - U * factor.error(T)).norm(), 1e-12);
    for (std::size_t node = 0; node < 4; ++node) {
      for (int axis = 0; axis < 6; ++axis) {
        auto ahead = T, back = T;
        ahead[node] = boxplus(T[node], kStep * Tangent::Unit(axis));
        back[node] = boxplus(T[node], -kStep * Tangent::Unit(axis));
        const Eigen::Vector3d change = U * (factor.error(ahead) - factor.error(back));
        EXPECT_LT((change / (2 * kStep) - at.jacobians[node].col(axis)).norm(), 1e-7)
            << node << " " << axis;
      }
    }
  }
}

TEST(GravityFactor, MovingAllNodesTogetherChangesNothing) {
  RandomNumbers random(2);
  const GravityFactor factor = someFactor(random);
  const auto T = somePoses(random);
  const Pose moved = random.pose(50.0);
  EXPECT_LT(
      (factor.error(T) - factor.error({moved * T[0], moved * T[1], moved * T[2], moved * T[3]}))
          .norm(),
      1e-12);
}

TEST(GravityFactor, YawOfTheLevelFrameChangesNothing) {
  RandomNumbers random(3);
  const GravityFactor factor = someFactor(random);
  auto T = somePoses(random);
  const Eigen::Vector3d before = factor.error(T);
  T[2] = boxplus(T[2], 0.7 * Tangent::Unit(5));
  EXPECT_LT((factor.error(T) - before).norm(), 1e-12);
}

}  // namespace
}  // namespace revisit_slam
