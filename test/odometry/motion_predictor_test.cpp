// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/motion_predictor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace revisit_slam {
namespace {

constexpr double kSpeed = 5.0;

Stamp stampAt(double seconds) {
  return Stamp::fromSeconds(1000.0 + seconds);
}

Pose poseAt(double seconds) {
  return {Eigen::Quaterniond::Identity(), {kSpeed * seconds, 0.0, 0.0}};
}

ConstantVelocityPredictor drivenFor(int scans, const Matrix6& information) {
  ConstantVelocityPredictor predictor{OdometryConfig()};
  for (int i = 0; i < scans; ++i) predictor.observe(stampAt(0.1 * i), poseAt(0.1 * i), information);
  return predictor;
}

const Matrix6 kPrecise = 1e6 * Matrix6::Identity();

TEST(ConstantVelocityPredictor, KnowsNothingBeforeTwoScans) {
  EXPECT_FALSE(drivenFor(0, kPrecise).predict(stampAt(0.0)).covariance);
  EXPECT_FALSE(drivenFor(1, kPrecise).predict(stampAt(0.1)).covariance);
  EXPECT_TRUE(drivenFor(2, kPrecise).predict(stampAt(0.2)).covariance);
}

TEST(ConstantVelocityPredictor, GoesOnAndIsTheSurerTheLongerTheMotionWasSteady) {
  const PredictedMotion early = drivenFor(3, kPrecise).predict(stampAt(0.3));
  const PredictedMotion late = drivenFor(200, kPrecise).predict(stampAt(20.0));
  EXPECT_NEAR(late.T_previous_base.translation.x(), 0.1 * kSpeed, 1e-6);
  EXPECT_LT((*late.covariance)(0, 0), 0.1 * (*early.covariance)(0, 0));
}

TEST(ConstantVelocityPredictor, AGapLeavesOutAsMuchAsTheCovarianceSays) {
  const ConstantVelocityPredictor predictor = drivenFor(200, kPrecise);
  const PredictedMotion predicted = predictor.predict(stampAt(23.9));
  ASSERT_TRUE(predicted.is_after_gap);
  const double missing = 4.0 * kSpeed - predicted.T_previous_base.translation.x();
  EXPECT_GT((*predicted.covariance)(0, 0), missing * missing);
}

TEST(ConstantVelocityPredictor, AScanThatTellsNothingIsNoReasonToGoOnForEver) {
  ConstantVelocityPredictor predictor = drivenFor(200, kPrecise);
  double position = kSpeed * 19.9, missing_variance = 0.0;
  for (int i = 0; i < 100; ++i) {
    const PredictedMotion predicted = predictor.predict(stampAt(20.0 + 0.1 * i));
    position += predicted.T_previous_base.translation.x();
    missing_variance += (*predicted.covariance)(0, 0);
    predictor.observe(stampAt(20.0 + 0.1 * i),
                      {Eigen::Quaterniond::Identity(), {position, 0.0, 0.0}}, Matrix6::Zero());
  }
  EXPECT_NEAR(position, kSpeed * (19.9 + OdometryConfig().max_prediction_time), 0.02);
  EXPECT_GT(missing_variance, 90 * 0.25 * kSpeed * 0.1 * kSpeed * 0.1);  // it may well have gone on
  EXPECT_TRUE(predictor.predict(stampAt(30.0)).is_after_gap);
}

/// Of a gyro there is information even so, but not of the way. What is caught up with the first
/// scan that tells was driven in all the time.
TEST(ConstantVelocityPredictor, GoesOnOnceAScanTellsOfTheMotionAgain) {
  Matrix6 of_gyro = Matrix6::Identity() / 1e6;
  of_gyro.bottomRightCorner<3, 3>() = 1e6 * Eigen::Matrix3d::Identity();
  for (const Matrix6& nothing : {Matrix6(Matrix6::Zero()), of_gyro}) {
    ConstantVelocityPredictor predictor = drivenFor(200, kPrecise);
    for (int i = 0; i < 20; ++i)
      predictor.observe(stampAt(20.0 + 0.1 * i), poseAt(std::min(20.0 + 0.1 * i, 20.9)), nothing);
    EXPECT_NEAR(predictor.predict(stampAt(22.0)).seconds_untold, 2.1, 1e-9);
    predictor.observe(stampAt(22.0), poseAt(22.0), kPrecise);
    const PredictedMotion predicted = predictor.predict(stampAt(22.1));
    EXPECT_TRUE(predicted.is_known);
    EXPECT_NEAR(predicted.T_previous_base.translation.x(), 0.1 * kSpeed, 1e-6);
  }
}

TEST(ConstantVelocityPredictor, ForgetsTheMotionWhenTheTrackIsLost) {
  ConstantVelocityPredictor predictor = drivenFor(20, kPrecise);
  predictor.forget();
  predictor.observe(stampAt(2.0), poseAt(5.0), Matrix6::Zero());
  const PredictedMotion predicted = predictor.predict(stampAt(2.1));
  EXPECT_FALSE(predicted.is_known);
  EXPECT_FALSE(predicted.covariance);
  EXPECT_EQ(predicted.T_previous_base.translation.norm(), 0.0);
  EXPECT_NEAR(predicted.seconds, 0.1, 1e-9);
}

}  // namespace
}  // namespace revisit_slam
