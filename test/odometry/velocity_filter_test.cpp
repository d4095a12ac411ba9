// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/velocity_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace revisit_slam {
namespace {

constexpr double kSeconds = 0.1;

Matrix6 informationOf(double sigma) {
  return Matrix6::Identity() / (sigma * sigma);
}

VelocityFilter started() {
  VelocityFilter filter;
  filter.start(kSeconds, informationOf(0.01));
  return filter;
}

/// Observes deviations of alternating signs along x and none along the other axes.
void shake(VelocityFilter& filter, double deviation, const Matrix6& information, int scans) {
  for (int i = 0; i < scans; ++i) {
    Tangent d = Tangent::Zero();
    d[0] = i % 2 == 0 ? deviation : -deviation;
    filter.update({}, kSeconds, d, information);
  }
}

TEST(VelocityFilter, FollowsAPreciseRegistration) {
  VelocityFilter filter = started();
  shake(filter, 0.0, informationOf(1e-5), 2);  // where it is, it is precise as well
  const Tangent deviation = Tangent::Constant(0.02);
  const Tangent change = filter.update({}, kSeconds, deviation, informationOf(1e-5));
  EXPECT_LT((change - deviation / kSeconds).norm(), 0.1 * change.norm());
}

TEST(VelocityFilter, LearnsHowJerkyThePlatformIs) {
  VelocityFilter filter = started();
  shake(filter, 0.02, informationOf(1e-4), 600);
  EXPECT_NEAR(filter.acceleration()[0], 0.02 / (kSeconds * kSeconds), 0.5);
  EXPECT_LT(filter.acceleration()[1], 0.5);
  const Matrix6 covariance = filter.predictedCovariance({}, kSeconds);
  EXPECT_GT(covariance(0, 0), 4.0 * covariance(1, 1));
}

TEST(VelocityFilter, WhatIsNotObservedIsNoObservationOfRest) {
  VelocityFilter filter = started();
  Matrix6 information = informationOf(1e-4);
  information.row(0).setZero();
  information.col(0).setZero();
  shake(filter, 0.0, information, 300);
  EXPECT_NEAR(filter.acceleration()[0], started().acceleration()[0], 0.01);
  EXPECT_LT(filter.acceleration()[1], 1.0);
}

TEST(VelocityFilter, ForgetsTheVelocityWhereNothingIsObserved) {
  VelocityFilter filter = started();
  shake(filter, 0.0, informationOf(1e-3), 300);
  const double before = filter.predictedCovariance({}, kSeconds)(0, 0);
  shake(filter, 0.0, Matrix6::Zero(), 20);
  const double after = filter.predictedCovariance({}, kSeconds)(0, 0);
  EXPECT_GT(after, 10.0 * before);
  shake(filter, 0.0, informationOf(1e-3), 5);
  EXPECT_LT(filter.predictedCovariance({}, kSeconds)(0, 0), 3.0 * before);
}

TEST(VelocityFilter, AveragesOverRegistrationsThatAreLessPreciseThanTheMotionIsSteady) {
  VelocityFilter filter = started();
  shake(filter, 0.0, informationOf(0.03), 600);
  const Tangent change = filter.update({}, kSeconds, Tangent::Constant(0.01), informationOf(0.03));
  EXPECT_LT(change[1], 0.75 * 0.01 / kSeconds);
}

}  // namespace
}  // namespace revisit_slam
