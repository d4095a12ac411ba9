// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/fused_motion_predictor.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "support/measured_motion.h"

namespace revisit_slam {
namespace {

const Stamp kStart = Stamp::fromSeconds(1000.0);

Tangent ahead(double speed) {
  Tangent velocity = Tangent::Zero();
  velocity[0] = speed;
  return velocity;
}

/// A vehicle whose wheels and registrations are set for each scan.
class Vehicle {
 public:
  explicit Vehicle(double registered_sigma)
      : information_(Matrix6::Identity() / (registered_sigma * registered_sigma)) {
    config_.odometry_topic = "/wheels";
    priors_ = std::make_unique<MotionPriors>(config_);
    predictor_ = std::make_unique<FusedMotionPredictor>(
        OdometryConfig{}, std::make_unique<ConstantVelocityPredictor>(OdometryConfig{}), config_,
        *priors_);
    tell();
    predictor_->observe(stamp(), pose_, information_);
  }

  /// A scan later; @return the prediction.
  PredictedMotion go(double speed, double speed_of_wheels) {
    ++scan_;
    wheels_ = boxplus(wheels_, 0.1 * ahead(speed_of_wheels));
    tell();
    PredictedMotion predicted = predictor_->predict(stamp());
    pose_ = boxplus(pose_, 0.1 * ahead(speed));
    predictor_->observe(stamp(), pose_, information_);
    return predicted;
  }
  /// Likewise, without a message.
  PredictedMotion goWithoutWheels(double speed) {
    ++scan_;
    PredictedMotion predicted = predictor_->predict(stamp());
    pose_ = boxplus(pose_, 0.1 * ahead(speed));
    predictor_->observe(stamp(), pose_, information_);
    return predicted;
  }

  /// No scans for a while, and wheels that go on.
  void pause(double seconds, double speed) {
    for (int i = 0; i < static_cast<int>(10.0 * seconds); ++i) {
      ++scan_;
      wheels_ = boxplus(wheels_, 0.1 * ahead(speed));
      pose_ = boxplus(pose_, 0.1 * ahead(speed));
      tell();
    }
  }

  void loseTrack() { predictor_->forget(); }

  const PriorAccount& account() const { return priors_->accounts().at("odometry"); }

 private:
  Stamp stamp() const { return kStart.plusSeconds(0.1 * scan_); }
  void tell() {
    OdometryReading reading;
    reading.stamp = stamp();
    reading.T_world_base = wheels_;
    priors_->take(reading);
  }

  PriorsConfig config_;
  std::unique_ptr<MotionPriors> priors_;
  std::unique_ptr<FusedMotionPredictor> predictor_;
  Matrix6 information_;
  Pose pose_, wheels_;
  int scan_ = 0;
};

TEST(FusedMotionPredictor, FollowsWheelsWhereTheVelocityChanges) {
  Vehicle vehicle(0.01);
  for (int i = 0; i < 20; ++i) vehicle.go(10.0, 10.0);
  const PredictedMotion braking = vehicle.go(9.0, 9.0);
  EXPECT_TRUE(braking.is_measured);
  EXPECT_TRUE(braking.is_known);
  EXPECT_NEAR(braking.T_previous_base.translation.x(), 0.9, 0.04);
  EXPECT_LT(braking.covariance->coeff(0, 0), 0.03 * 0.03);
  EXPECT_LT((braking.velocity.after(0.1).translation - braking.T_previous_base.translation).norm(),
            1e-9);
}

TEST(FusedMotionPredictor, KnowsTheMotionOfTheSecondScan) {
  EXPECT_NEAR(Vehicle(0.01).go(10.0, 10.0).T_previous_base.translation.x(), 1.0, 0.01);
}

TEST(FusedMotionPredictor, WithoutReadingsThePredictionIsThatOfTheOther) {
  Vehicle with(0.01);
  ConstantVelocityPredictor other{OdometryConfig{}};
  for (int i = 0; i < 10; ++i) with.go(10.0, 10.0);
  const PredictedMotion predicted = with.goWithoutWheels(10.0);
  EXPECT_FALSE(predicted.is_measured);
  EXPECT_NEAR(predicted.T_previous_base.translation.x(), 1.0, 1e-6);
  EXPECT_EQ(with.account().missing, 1u);
  EXPECT_EQ(with.account().used, 10u);
}

/// On ice: the wheels jump to another speed.
TEST(FusedMotionPredictor, WheelsThatSlipAreRejected) {
  Vehicle vehicle(0.01);
  for (int i = 0; i < 20; ++i) vehicle.go(5.0, 5.0);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(vehicle.go(5.0, 25.0).T_previous_base.translation.x(), 0.5, 0.02) << i;
  EXPECT_GE(vehicle.account().rejected, 3u);  // of others the weight is next to nothing
  for (int i = 0; i < 30; ++i) vehicle.go(5.0, 5.0);
  const PredictedMotion braking = vehicle.go(4.5, 4.5);
  EXPECT_TRUE(braking.is_measured);  // they are trusted again
  EXPECT_NEAR(braking.T_previous_base.translation.x(), 0.45, 0.02);
}

/// On a ferry: the wheels stand still, the world does not, and that begins so slowly that no single
/// scan tells.
TEST(FusedMotionPredictor, WheelsThatStandOnSomethingThatMovesLoseTheirWeight) {
  Vehicle vehicle(0.005);
  for (int i = 0; i < 20; ++i) vehicle.go(0.0, 0.0);
  double predicted = 0.0;
  for (int i = 0; i < 60; ++i)
    predicted = vehicle.go(0.05 * i, 0.0).T_previous_base.translation.x();
  EXPECT_NEAR(predicted, 0.1 * 0.05 * 59, 0.02);
}

TEST(FusedMotionPredictor, WhereTheTrackWasLostWheelsTellTheNextMotion) {
  Vehicle vehicle(0.01);
  for (int i = 0; i < 20; ++i) vehicle.go(5.0, 5.0);
  vehicle.loseTrack();
  vehicle.go(5.0, 5.0);  // where from is not known
  const PredictedMotion predicted = vehicle.go(5.0, 5.0);
  EXPECT_TRUE(predicted.is_measured);
  EXPECT_NEAR(predicted.T_previous_base.translation.x(), 0.5, 0.02);
}

TEST(FusedMotionPredictor, BesideWheelsARegistrationCountsForOneOfManyScans) {
  Vehicle vehicle(0.01);
  for (int i = 0; i < 30; ++i) vehicle.go(10.0, 10.0);
  const PredictedMotion predicted = vehicle.go(10.0, 10.0);
  const Matrix6 honest = predicted.covariance->inverse();
  EXPECT_GT(predicted.information(0, 0), 5.0 * honest(0, 0));
  EXPECT_LT(predicted.information(0, 0), 60.0 * honest(0, 0));
}

TEST(FusedMotionPredictor, FollowsWheelsOfAnotherDiameterOnceItKnowsThat) {
  Vehicle vehicle(0.003);
  for (int i = 0; i < 600; ++i) vehicle.go(10.0, 10.1);
  EXPECT_NEAR(vehicle.account().scale.value(), 10.0 / 10.1, 0.001);
  EXPECT_NEAR(vehicle.go(10.0, 10.1).T_previous_base.translation.x(), 1.0, 0.002);
}

TEST(FusedMotionPredictor, AfterAPauseOfMinutesWheelsAreWeighedByTheirOwnError) {
  Vehicle vehicle(0.01);
  for (int i = 0; i < 30; ++i) vehicle.go(10.0, 10.0);
  vehicle.pause(600.0, 10.0);
  const PredictedMotion predicted = vehicle.go(10.0, 10.0);
  ASSERT_TRUE(predicted.is_measured);
  EXPECT_NEAR(predicted.T_previous_base.translation.x(), 6001.0, 60.0);
  for (const Matrix6& information :
       {predicted.information, predicted.covariance->inverse().eval()}) {
    ASSERT_TRUE(information.allFinite());
    const Eigen::SelfAdjointEigenSolver<Matrix6> along_axes(information);
    EXPECT_GT(along_axes.eigenvalues().minCoeff(), 0.0);
    EXPECT_LT(along_axes.eigenvalues().maxCoeff(), 1e9);
  }
  ASSERT_TRUE(predicted.sweep);
}

/// A registration that tells nothing cannot contradict.
TEST(FusedMotionPredictor, WhereNothingIsRegisteredTheWheelsAreTrusted) {
  Vehicle vehicle(100.0);
  for (int i = 0; i < 50; ++i) vehicle.go(4.0, 5.0);
  EXPECT_EQ(vehicle.account().rejected, 0u);
  EXPECT_NEAR(vehicle.go(4.0, 5.0).T_previous_base.translation.x(), 0.5, 0.02);
}

}  // namespace
}  // namespace revisit_slam
