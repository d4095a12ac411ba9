// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/motion_priors.h"

#include <gtest/gtest.h>

#include "support/measured_motion.h"

namespace revisit_slam {
namespace {

const Stamp kStart = Stamp::fromSeconds(1000.0);

PriorsConfig both() {
  PriorsConfig config;
  config.odometry_topic = "/wheels";
  config.imu_topic = "/imu";
  return config;
}

TEST(MotionPriors, AreOffUnlessConnected) {
  MotionPriors priors{PriorsConfig{}};
  EXPECT_FALSE(priors.isConnected());
  EXPECT_TRUE(priors.reach(kStart));
  EXPECT_TRUE(priors.measure(kStart, kStart.plusSeconds(0.1)).empty());
}

TEST(MotionPriors, TwoOdometriesAreRefused) {
  PriorsConfig config = both();
  config.odometry_frame = "wheel_odom";
  EXPECT_THROW(MotionPriors{config}, ParameterError);
}

TEST(MotionPriors, WaitForAllThatAreNotSilent) {
  MotionPriors priors(both());
  const Stamp scan = kStart.plusSeconds(0.1);
  priors.take(odometryAt(kStart, 0.12, Tangent::Zero()));
  EXPECT_FALSE(priors.reach(scan));
  priors.take(imuAt(kStart, 0.1, Eigen::Vector3d::Zero()));
  EXPECT_TRUE(priors.reach(scan));
  EXPECT_FALSE(priors.reach(kStart.plusSeconds(0.2)));
}

TEST(MotionPriors, OneThatWasGivenUpIsWaitedForAgainWhenItSends) {
  MotionPriors priors(both());
  priors.take(odometryAt(kStart, 0.0, Tangent::Zero()));
  for (const double t : {0.0, 0.1, 0.2}) priors.take(imuAt(kStart, t, Eigen::Vector3d::Zero()));
  EXPECT_EQ(priors.giveUp(kStart.plusSeconds(0.1)), "odometry");
  EXPECT_TRUE(priors.reach(kStart.plusSeconds(0.2)));
  EXPECT_TRUE(priors.accounts().at("odometry").is_silent);
  priors.take(odometryAt(kStart, 0.15, Tangent::Zero()));
  EXPECT_FALSE(priors.reach(kStart.plusSeconds(0.2)));
}

/// Whoever is always late would delay every scan for nothing.
TEST(MotionPriors, OneThatStaysBehindIsNotWaitedFor) {
  MotionPriors priors(both());
  for (const double t : {0.0, 0.1, 0.2}) priors.take(imuAt(kStart, t, Eigen::Vector3d::Zero()));
  priors.giveUp(kStart.plusSeconds(0.1));
  priors.take(odometryAt(kStart, 0.05, Tangent::Zero()));
  EXPECT_TRUE(priors.reach(kStart.plusSeconds(0.2)));
}

TEST(MotionPriors, AccountForEveryMessage) {
  MotionPriors priors(both());
  for (const double t : {0.0, 0.1, 0.1, 0.05}) priors.take(odometryAt(kStart, t, Tangent::Zero()));
  priors.countDropped("odometry", "no transform from 'wheels'");
  const PriorAccount& account = priors.accounts().at("odometry");
  EXPECT_EQ(account.received, 5u);
  EXPECT_EQ(account.dropped.at("duplicate stamp"), 1u);
  EXPECT_EQ(account.dropped.at("out of order"), 1u);
  EXPECT_EQ(account.dropped.at("no transform from 'wheels'"), 1u);
}

TEST(MotionPriors, ReportTheBiasOfTheGyroUntilTheSessionEnds) {
  MotionPriors priors(both());
  const Eigen::Vector3d bias{0.01, -0.006, 0.004};
  for (int i = 0; i <= 400; ++i) priors.take(imuAt(kStart, 0.1 * i, bias));
  EXPECT_FALSE(priors.accounts().at("gyro").bias);
  const RegistrationEvidence evidence{1e8 * Matrix6::Identity(), Matrix6::Identity()};
  for (int i = 0; i < 400; ++i)
    priors.observe(kStart.plusSeconds(0.1 * i), kStart.plusSeconds(0.1 * (i + 1)), Pose{},
                   evidence);
  EXPECT_LT((*priors.accounts().at("gyro").bias - bias).norm(), 5e-4);
  EXPECT_FALSE(priors.accounts().at("odometry").bias);
  priors.restart();
  EXPECT_FALSE(priors.accounts().at("gyro").bias);
}

/// Wheels that jump tell nothing of their diameter.
TEST(MotionPriors, WhatWasRejectedIsNoEvidence) {
  for (const bool is_rejected : {false, true}) {
    MotionPriors priors(both());
    for (int i = 0; i <= 40; ++i)
      priors.take(odometryAt(kStart, 0.1 * i, (Tangent() << 5, 0, 0, 0, 0, 0).finished()));
    const RegistrationEvidence evidence{1e6 * Matrix6::Identity(), Matrix6::Identity()};
    for (int i = 0; i < 40; ++i) {
      Pose T_from_to;
      T_from_to.translation.x() = 0.5 * 1.01;
      priors.observe(kStart.plusSeconds(0.1 * i), kStart.plusSeconds(0.1 * (i + 1)), T_from_to,
                     evidence,
                     is_rejected && i % 15 == 7 ? std::set<std::string>{MotionPriors::kOdometry}
                                                : std::set<std::string>{});
    }
    EXPECT_EQ(*priors.account(MotionPriors::kOdometry).scale > 1.001, !is_rejected);
  }
}

}  // namespace
}  // namespace revisit_slam
