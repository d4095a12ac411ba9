// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/position_factor.h"

#include <gtest/gtest.h>

#include "revisit_slam/pose_graph/factor_cost.h"
#include "revisit_slam/pose_graph/information_root.h"
#include "revisit_slam/pose_graph/pose_block.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

PositionFactor someFactor(RandomNumbers& random) {
  PositionFactor factor{{NodeId{0}}, random.pose(3.0).translation, random.pose(50.0).translation};
  Eigen::Matrix3d A;
  for (int i = 0; i < 9; ++i) A(i / 3, i % 3) = random.uniform(-1.0, 1.0);
  factor.information = A * A.transpose() + 0.1 * Eigen::Matrix3d::Identity();
  return factor;
}

TEST(PositionFactor, JacobianEqualsDifferences) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const PositionFactor factor = someFactor(random);
    const Eigen::Matrix3d U = informationRoot(factor.information);
    const Pose T = random.pose(50.0);
    const auto at = factor.linearized({T}, U);
    EXPECT_LT((at.residual - U * factor.error({T})).norm(), 1e-12 * (1.0 + at.residual.norm()));
    constexpr double kStep = 1e-6;
    for (int axis = 0; axis < 6; ++axis) {
      const Tangent d = kStep * Tangent::Unit(axis);
      const Eigen::Vector3d change =
          U * (factor.error({boxplus(T, d)}) - factor.error({boxplus(T, -d)}));
      EXPECT_LT((change / (2 * kStep) - at.jacobians[0].col(axis)).norm(), 1e-7) << axis;
    }
  }
}

/// As the solver sees it: by the entries of the pose block, along the manifold.
TEST(PositionFactor, TermOfTheSolverHasTheSameJacobian) {
  RandomNumbers random(2);
  const Factor factor{someFactor(random), {}};
  const Pose T = random.pose(50.0);
  const PoseBlock block = blockOf(T);
  const double* blocks[] = {block.data()};
  Eigen::Vector3d residual;
  Eigen::Matrix<double, 3, 7, Eigen::RowMajor> by_block;
  double* jacobians[] = {by_block.data()};
  ASSERT_TRUE(makeCost(factor)->Evaluate(blocks, residual.data(), jacobians));
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  PoseChart::plusJacobian(block.data(), plus.data());
  const auto& measured = std::get<PositionFactor>(factor.measurement);
  const auto expected = measured.linearized({T}, informationRoot(measured.information));
  EXPECT_LT((by_block * plus - expected.jacobians[0]).norm(), 1e-12);
  EXPECT_NEAR(residual.squaredNorm(), factor.chi2({T}), 1e-9 * residual.squaredNorm());
}

TEST(PositionFactor, IsThatOfTheLeverInTheMap) {
  PositionFactor factor{{NodeId{0}}, {1.0, 0.0, 2.0}, {10.0, 1.5, 2.0}};
  factor.information.diagonal() << 1.0, 4.0, 9.0;
  const Pose turned{expSO3({0.0, 0.0, M_PI / 2}), {10.0, 0.0, 0.0}};  // the lever points along y
  EXPECT_LT((factor.error({turned}) - Eigen::Vector3d(0.0, -0.5, 0.0)).norm(), 1e-12);
  EXPECT_NEAR((Factor{factor, {}}.chi2({turned})), 1.0, 1e-12);
  EXPECT_TRUE(factor.isFinite());
  factor.p_map.z() = std::nan("");
  EXPECT_FALSE(factor.isFinite());
}

}  // namespace
}  // namespace revisit_slam
