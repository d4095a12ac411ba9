// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/relative_position_factor.h"

#include <gtest/gtest.h>

#include "revisit_slam/pose_graph/information_root.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

RelativePositionFactor someFactor(RandomNumbers& random) {
  RelativePositionFactor factor{{NodeId{0}, NodeId{1}}, random.inCube(3.0), random.inCube(50.0)};
  Eigen::Matrix3d A;
  for (int i = 0; i < 9; ++i) A(i / 3, i % 3) = random.uniform(-1.0, 1.0);
  factor.information = A * A.transpose() + 0.1 * Eigen::Matrix3d::Identity();
  return factor;
}

TEST(RelativePositionFactor, JacobiansEqualDifferences) {
  RandomNumbers random(1);
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const RelativePositionFactor factor = someFactor(random);
    const Eigen::Matrix3d U = informationRoot(factor.information);
    const RelativePositionFactor::Shape::Poses T = {random.pose(50.0), random.pose(50.0)};
    const auto at = factor.linearized(T, U);
    EXPECT_LT((at.residual - U * factor.error(T)).norm(), 1e-12 * (1.0 + at.residual.norm()));
    for (std::size_t node = 0; node < 2; ++node) {
      for (int axis = 0; axis < 6; ++axis) {
        auto ahead = T, back = T;
        ahead[node] = boxplus(T[node], kStep * Tangent::Unit(axis));
        back[node] = boxplus(T[node], -kStep * Tangent::Unit(axis));
        const Eigen::Vector3d change = U * (factor.error(ahead) - factor.error(back));
        EXPECT_LT((change / (2 * kStep) - at.jacobians[node].col(axis)).norm(), 1e-6)
            << node << " " << axis;
      }
    }
  }
}

TEST(RelativePositionFactor, MovingBothNodesTogetherChangesNothing) {
  RandomNumbers random(2);
  const RelativePositionFactor factor = someFactor(random);
  const Pose T_0 = random.pose(50.0), T_1 = random.pose(50.0), moved = random.pose(50.0);
  EXPECT_LT((factor.error({T_0, T_1}) - factor.error({moved * T_0, moved * T_1})).norm(), 1e-9);
}

}  // namespace
}  // namespace revisit_slam
