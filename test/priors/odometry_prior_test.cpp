// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/odometry_prior.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/measured_motion.h"

namespace revisit_slam {
namespace {

const Stamp kStart = Stamp::fromSeconds(1000.0);
const Tangent kVelocity = (Tangent() << 5.0, 0.1, 0.0, 0.0, 0.02, 0.4).finished();

OdometryPrior priorUntil(double end, double step = 0.1) {
  OdometryPrior prior{PriorsConfig{}};
  for (int i = 0; i * step < end + 1e-9; ++i)
    prior.readings().take(odometryAt(kStart, i * step, kVelocity));
  return prior;
}

TEST(OdometryPrior, InterpolatesBetweenItsReadings) {
  const auto motion = priorUntil(1.0).motion(kStart.plusSeconds(0.23), kStart.plusSeconds(0.37));
  ASSERT_TRUE(motion);
  EXPECT_LT(log(motion->T_from_to.inverse() * exp(0.14 * kVelocity)).norm(), 1e-9);
}

TEST(OdometryPrior, TellsNothingBeforeBetweenAndAfterReadingsThatAreFarApart) {
  const OdometryPrior sparse = priorUntil(1.0, 0.5);  // more than max_gap apart
  EXPECT_FALSE(sparse.motion(kStart, kStart.plusSeconds(0.3)));
  EXPECT_TRUE(sparse.motion(kStart, kStart.plusSeconds(0.5)));  // just then
  const OdometryPrior dense = priorUntil(1.0);
  EXPECT_FALSE(dense.motion(kStart.plusSeconds(-0.1), kStart.plusSeconds(0.3)));
  EXPECT_FALSE(dense.motion(kStart.plusSeconds(0.8), kStart.plusSeconds(1.05)));
}

TEST(OdometryPrior, WithoutCovarianceTheErrorGrowsWithWhatWasTravelled) {
  const OdometryPrior prior = priorUntil(1.0);
  const auto sigma = [&](double seconds, Eigen::Index axis) {
    return std::sqrt(prior.motion(kStart, kStart.plusSeconds(seconds))->covariance(axis, axis));
  };
  EXPECT_NEAR(sigma(1.0, 0), std::hypot(0.02, 0.005) * 5.0, 0.01);
  EXPECT_GT(sigma(1.0, 5), 0.002 * 5.0);
  EXPECT_NEAR(sigma(1.0, 0) / sigma(0.5, 0), 2.0, 0.05);
}

TEST(OdometryPrior, AcrossTheWayTheErrorIsThatOfSlip) {
  OdometryPrior prior{PriorsConfig{}};
  const Tangent forwards_and_aside = (Tangent() << 3.0, 3.0, 0.0, 0.0, 0.0, 0.0).finished();
  for (const double t : {0.0, 0.1})
    prior.readings().take(odometryAt(kStart, t, forwards_and_aside));
  const Matrix6 covariance = prior.motion(kStart, kStart.plusSeconds(0.1))->covariance;
  const auto sigma = [&](const Eigen::Vector3d& axis) {
    return std::sqrt(axis.dot(covariance.topLeftCorner<3, 3>() * axis));
  };
  const double way = 0.1 * 3.0 * std::sqrt(2.0);
  EXPECT_NEAR(sigma(Eigen::Vector3d(1.0, 1.0, 0.0).normalized()), std::hypot(0.02, 0.005) * way,
              1e-3);
  EXPECT_LT(sigma(Eigen::Vector3d(1.0, -1.0, 0.0).normalized()), 0.01 * way);
  EXPECT_LT(sigma(Eigen::Vector3d::UnitZ()), 0.01 * way);
}

TEST(OdometryPrior, ACovarianceOfTheVelocityIsTaken) {
  OdometryPrior prior = priorUntil(0.0);
  OdometryReading reading = odometryAt(kStart, 0.1, kVelocity);
  Matrix6 covariance = Matrix6::Zero();
  covariance.diagonal() << 0.25, 0.01, kUnmeasured, kUnmeasured, kUnmeasured, 0.04;
  reading.velocity_covariance = covariance;
  prior.readings().take(reading);
  const Matrix6 of_motion = prior.motion(kStart, reading.stamp)->covariance;
  EXPECT_NEAR(std::sqrt(of_motion(0, 0)), std::hypot(0.05, 0.02 * 0.5), 1e-3);
  EXPECT_NEAR(std::sqrt(of_motion(5, 5)), 0.02, 1e-3);
  EXPECT_GT(of_motion(3, 3), 1e3);
}

TEST(OdometryPrior, OfCorrelationsThatCannotBeTheVariancesAreTaken) {
  OdometryPrior prior = priorUntil(0.0);
  OdometryReading reading = odometryAt(kStart, 0.1, kVelocity);
  Matrix6 covariance = 0.01 * Matrix6::Identity();
  covariance(0, 1) = covariance(1, 0) = 0.5;
  reading.velocity_covariance = covariance;
  prior.readings().take(reading);
  const Matrix6 of_motion = prior.motion(kStart, reading.stamp)->covariance;
  EXPECT_GT(of_motion.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
  EXPECT_NEAR(std::sqrt(of_motion(1, 1)), 0.1 * 0.1, 1e-3);
}

TEST(OdometryPrior, APlanarOneTellsNothingOfHeightAndTilt) {
  OdometryPrior prior = priorUntil(0.0);
  OdometryReading reading = odometryAt(kStart, 0.1, kVelocity);
  reading.is_planar = true;
  prior.readings().take(reading);
  const Matrix6 covariance = prior.motion(kStart, reading.stamp)->covariance;
  for (const int axis : {2, 3, 4}) EXPECT_GE(covariance(axis, axis), kUnmeasured);
  for (const int axis : {0, 1, 5}) EXPECT_LT(covariance(axis, axis), 0.1);
}

TEST(OdometryPrior, AStandstillIsNotKnownExactly) {
  OdometryPrior prior{PriorsConfig{}};
  for (const double t : {0.0, 0.1}) prior.readings().take(odometryAt(kStart, t, Tangent::Zero()));
  const auto motion = prior.motion(kStart, kStart.plusSeconds(0.1));
  EXPECT_GT(motion->covariance.diagonal().minCoeff(), 0.0);
}

/// Straight on at 5 m/s, 0.1 s a scan.
class WheelsOfAnotherDiameter : public ::testing::Test {
 protected:
  static constexpr double kTrueScale = 1.015;

  /// Registered metre by metre, `dragged` of each the wrong way.
  void drive(int scans, double weight, double dragged = 0.0, double share = 1.0) {
    const RegistrationEvidence evidence{weight * Matrix6::Identity(), share * Matrix6::Identity()};
    for (int i = 0; i < scans; ++i, ++scan_) {
      const Stamp from = kStart.plusSeconds(0.1 * scan_),
                  to = kStart.plusSeconds(0.1 * scan_ + 0.1);
      for (const double t : {0.1 * scan_, 0.1 * scan_ + 0.1})
        prior_.readings().take(odometryAt(kStart, t, kForwards));
      Pose T_from_to;
      T_from_to.translation.x() = (1.0 - dragged) * kTrueScale * 0.5;
      prior_.observe(from, to, T_from_to, evidence);
    }
  }
  double sigma() const {
    const auto motion =
        prior_.motion(kStart.plusSeconds(0.1 * scan_ - 0.1), kStart.plusSeconds(0.1 * scan_));
    return std::sqrt(motion->covariance(0, 0)) / motion->T_from_to.translation.x();
  }

  const Tangent kForwards = (Tangent() << 5.0, 0.0, 0.0, 0.0, 0.0, 0.0).finished();
  OdometryPrior prior_{PriorsConfig{}};
  int scan_ = 0;
};

TEST_F(WheelsOfAnotherDiameter, AreKnownAfterSomeWay) {
  drive(10, 1e5);
  EXPECT_EQ(prior_.scale(), 1.0);
  const double before = sigma();
  drive(290, 1e5);
  EXPECT_NEAR(prior_.scale(), kTrueScale, 0.001);
  EXPECT_LT(sigma(), 0.5 * before);
  const auto motion = prior_.motion(kStart.plusSeconds(29.9), kStart.plusSeconds(30.0));
  EXPECT_NEAR(motion->T_from_to.translation.x(), 0.5 * kTrueScale, 1e-3);
}

TEST_F(WheelsOfAnotherDiameter, KeepTheirScaleWhereTheRegistrationKnowsLittle) {
  drive(300, 1e5);
  const double before = prior_.scale();
  drive(300, 10.0, 0.01);  // within the gate
  EXPECT_NEAR(prior_.scale(), before, 0.001);
}

TEST_F(WheelsOfAnotherDiameter, AreNotConfirmedByPosesThatFollowThem) {
  const double follows = 1.0 - 1.0 / kTrueScale;  // each pose is where the wheels say
  drive(20, 1e5, follows, 0.05);
  const double before = sigma();
  drive(280, 1e5, follows, 0.05);
  EXPECT_GT(sigma(), 0.8 * before);
}

/// Each pose has a part of what the registration says, and the rest of the wheels.
TEST(OdometryPrior, OfAWrongDiameterNoMoreIsKnownThanPosesShow) {
  constexpr double true_scale = 1.015, share = 0.3, way = 0.5;
  PriorsConfig config;
  config.odometry.translation_per_metre = 5e-4;  // what is left is the uncertainty of the scale
  OdometryPrior prior{config};
  const Tangent forwards = (Tangent() << 10.0 * way, 0.0, 0.0, 0.0, 0.0, 0.0).finished();
  const RegistrationEvidence evidence{1e5 * Matrix6::Identity(), share * Matrix6::Identity()};
  const auto at = [](int scan) { return kStart.plusSeconds(0.1 * scan); };
  prior.readings().take(odometryAt(kStart, 0.0, forwards));
  for (int scan = 1; scan <= 400; ++scan) {
    prior.readings().take(odometryAt(kStart, 0.1 * scan, forwards));
    Pose T_from_to;
    T_from_to.translation.x() = way * (prior.scale() + share * (true_scale - prior.scale()));
    prior.observe(at(scan - 1), at(scan), T_from_to, evidence);
  }
  const auto motion = prior.motion(at(390), at(400));
  ASSERT_TRUE(motion);
  const double sigma = std::sqrt(motion->covariance(0, 0)) / (10.0 * way);
  EXPECT_LT(std::abs(prior.scale() - true_scale), sigma);
  EXPECT_GT(prior.scale(), 1.005);
}

TEST_F(WheelsOfAnotherDiameter, AreNotJudgedByARegistrationGoneWrong) {
  drive(300, 1e5);
  const double before = prior_.scale();
  drive(20, 1e5, 0.2);
  EXPECT_EQ(prior_.scale(), before);
}

}  // namespace
}  // namespace revisit_slam
