// SPDX-License-Identifier: MIT
#include "revisit_slam/information/motion_covariance.h"

#include <gtest/gtest.h>

#include <random>

namespace revisit_slam {
namespace {

Matrix6 correlated() {
  const Matrix6 root = Matrix6::NullaryExpr(
      [](Eigen::Index i, Eigen::Index j) { return std::sin(1.0 + 2.0 * i + 5.0 * j); });
  return root * root.transpose() + Matrix6::Identity();
}

TEST(MotionCovariance, ScalesTheInverseByTheResiduals) {
  InformationConfig config;
  config.calibration = 3.0;
  config.deskew_share = 0.0;
  InformationEstimate estimate;
  estimate.information = correlated();
  estimate.mean_squared_residual = 0.5;
  const Matrix6 covariance = MotionCovariance(config).of(estimate);
  EXPECT_LT((covariance * estimate.information - 3.0 * Matrix6::Identity()).norm(), 1e-9);
}

TEST(MotionCovariance, GrowsWithTheChangesOfThePredictionsErrors) {
  InformationConfig config;
  config.deskew_share = 0.5;
  MotionCovariance covariance(config);
  const InformationEstimate estimate;  // no residuals: the registration's part is zero
  Tangent change;
  change << 0.1, 0.2, 0.3, 0.01, 0.02, 0.03;
  for (int i = 0; i < 200; ++i) covariance.observe(i % 2 == 0 ? change : Tangent::Zero());
  const Matrix6 expected = (0.5 * change).cwiseAbs2().asDiagonal();
  EXPECT_LT((covariance.of(estimate) - expected).norm(), 1e-9);
}

TEST(MotionCovariance, ConstantAccelerationBendsAllScansAlike) {
  InformationConfig config;
  config.deskew_share = 0.5;
  MotionCovariance covariance(config);
  for (int i = 0; i < 200; ++i) covariance.observe(Tangent::Constant(0.2));
  EXPECT_LT(covariance.of({}).norm(), 1e-9);
}

/// Against a sample of perturbed chains of poses.
TEST(PoseCovariance, IsThatOfTheEndOfAChain) {
  const Pose step = exp((Tangent() << 1.0, 0.2, -0.1, 0.05, -0.1, 0.3).finished());
  const Matrix6 covariance_motion = 1e-6 * correlated();
  const Matrix6 root = covariance_motion.llt().matrixL();
  PoseCovariance analytic;
  Pose end;
  for (int i = 0; i < 8; ++i) {
    analytic.move(step, covariance_motion);
    end = end * step;
  }
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Matrix6 sampled = Matrix6::Zero();
  constexpr int kSamples = 20000;
  for (int sample = 0; sample < kSamples; ++sample) {
    Pose T;
    for (int i = 0; i < 8; ++i)
      T = boxplus(T * step, root * Tangent::NullaryExpr([&] { return normal(random); }));
    const Tangent error = log(end.inverse() * T);
    sampled += error * error.transpose() / kSamples;
  }
  EXPECT_LT((sampled - analytic.base()).norm(), 0.04 * sampled.norm());
}

/// A wrong order or axis shows: the error is along the robot's forward axis, which is the map's y.
TEST(InFixedAxes, TurnsTheForwardAxisOfTheRobot) {
  Matrix6 forward = Matrix6::Zero();
  forward(0, 0) = 4.0;
  forward(3, 3) = 9.0;
  const Matrix6 fixed = inFixedAxes(forward, {expSO3({0.0, 0.0, M_PI / 2.0}), {100.0, 50.0, 0.0}});
  EXPECT_NEAR(fixed(1, 1), 4.0, 1e-12);
  EXPECT_NEAR(fixed(4, 4), 9.0, 1e-12);
  EXPECT_NEAR(fixed(0, 0), 0.0, 1e-12);
}

}  // namespace
}  // namespace revisit_slam
