// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/pose_block.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

PoseBlock plus(const PoseBlock& block, const Tangent& d) {
  PoseBlock moved;
  EXPECT_TRUE(PoseChart::plus(block.data(), d.data(), moved.data()));
  return moved;
}

TEST(PoseChart, PlusIsARightPerturbationAndMinusUndoesIt) {
  RandomNumbers random(1);
  for (int i = 0; i < 20; ++i) {
    const Pose T = random.pose(100.0);
    const Tangent d = random.tangent(2.0, 1.5);
    const PoseBlock block = blockOf(T), moved = plus(block, d);
    EXPECT_LT(distanceBetween(poseOf(moved.data()), T * exp(d)), 1e-12);
    Tangent back;
    EXPECT_TRUE(PoseChart::minus(moved.data(), block.data(), back.data()));
    EXPECT_LT((back - d).norm(), 1e-11);
  }
}

TEST(PoseChart, JacobianOfPlusEqualsDifferencesAndThatOfMinusInvertsIt) {
  RandomNumbers random(2);
  const PoseBlock block = blockOf(random.pose(3.0));
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> J;
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> inverse;
  PoseChart::plusJacobian(block.data(), J.data());
  PoseChart::minusJacobian(block.data(), inverse.data());
  EXPECT_LT((inverse * J - Matrix6::Identity()).norm(), 1e-14);
  constexpr double kStep = 1e-6;
  for (int axis = 0; axis < 6; ++axis) {
    const PoseBlock up = plus(block, kStep * Tangent::Unit(axis));
    const PoseBlock down = plus(block, -kStep * Tangent::Unit(axis));
    for (int row = 0; row < 7; ++row)
      EXPECT_NEAR((up[row] - down[row]) / (2 * kStep), J(row, axis), 1e-9);
  }
}

}  // namespace
}  // namespace revisit_slam
