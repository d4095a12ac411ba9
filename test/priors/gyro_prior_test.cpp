// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gyro_prior.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/measured_motion.h"

namespace revisit_slam {
namespace {

const Stamp kStart = Stamp::fromSeconds(1000.0);
const Eigen::Vector3d kBias{0.01, -0.006, 0.004};
const Matrix6 kKnown = 1e8 * Matrix6::Identity();

/// Nods twice a second, and turns.
Eigen::Quaterniond truthAt(double seconds) {
  return expSO3({0.0, 0.0, 0.3 * seconds}) * expSO3({0.0, 0.2 * std::sin(12.0 * seconds), 0.0});
}

Eigen::Vector3d rateAt(double seconds) {
  const double step = 1e-4;
  return logSO3(truthAt(seconds - step).conjugate() * truthAt(seconds + step)) / (2.0 * step);
}

void take(GyroPrior& prior, double from, double to, const Eigen::Vector3d& bias) {
  for (double t = from; t < to - 1e-9; t += 0.005)
    prior.readings().take(imuAt(kStart, t, rateAt(t) + bias));
}

TEST(GyroPrior, IntegratesBetweenAnyTwoInstants) {
  GyroPrior prior{PriorsConfig{}};
  take(prior, 0.0, 1.0, Eigen::Vector3d::Zero());
  const auto motion = prior.motion(kStart.plusSeconds(0.2031), kStart.plusSeconds(0.5077));
  ASSERT_TRUE(motion);
  const Eigen::Quaterniond truth = truthAt(0.2031).conjugate() * truthAt(0.5077);
  EXPECT_LT(motion->T_from_to.rotation.angularDistance(truth), 1e-4);
  EXPECT_GE(motion->covariance(0, 0), kUnmeasured);
  EXPECT_LT(motion->covariance(4, 4), 1e-3);
}

TEST(GyroPrior, TellsNothingWhereReadingsAreMissing) {
  GyroPrior prior{PriorsConfig{}};
  take(prior, 0.0, 0.3, Eigen::Vector3d::Zero());
  take(prior, 0.7, 1.0, Eigen::Vector3d::Zero());
  EXPECT_TRUE(prior.motion(kStart.plusSeconds(0.1), kStart.plusSeconds(0.2)));
  EXPECT_FALSE(prior.motion(kStart.plusSeconds(0.2), kStart.plusSeconds(0.8)));
  EXPECT_FALSE(prior.motion(kStart.plusSeconds(0.9), kStart.plusSeconds(1.1)));
  EXPECT_FALSE(prior.motion(kStart.plusSeconds(-0.1), kStart.plusSeconds(0.1)));
}

TEST(GyroPrior, LearnsItsBiasFromRegistrations) {
  GyroPrior prior{PriorsConfig{}};
  take(prior, 0.0, 0.1, kBias);
  double before = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double from = 0.1 * i, to = from + 0.1;
    take(prior, to, to + 0.1, kBias);
    const Stamp a = kStart.plusSeconds(from), b = kStart.plusSeconds(to);
    if (i == 0) before = prior.motion(a, b)->covariance(3, 3);
    Pose T_from_to;  // as registered, with errors that do not add up
    const auto wrong = [](double t) { return expSO3({1e-3 * std::sin(40.0 * t), 0.0, 0.0}); };
    T_from_to.rotation = (truthAt(from) * wrong(from)).conjugate() * truthAt(to) * wrong(to);
    prior.observe(a, b, T_from_to, kKnown);
  }
  EXPECT_LT((prior.bias() - kBias).norm(), 1e-3);
  const auto motion = prior.motion(kStart.plusSeconds(30.0), kStart.plusSeconds(30.08));
  ASSERT_TRUE(motion);
  EXPECT_LT(motion->covariance(3, 3), 0.1 * before);
}

TEST(GyroPrior, PosesThatFollowItSayNothingOfItsBias) {
  GyroPrior prior{PriorsConfig{}};
  const auto drive = [&](double begin, double end, bool is_heading_known) {
    Matrix6 information = kKnown;
    if (!is_heading_known) information(5, 5) = 0.0;
    for (double from = begin; from < end - 1e-9; from += 0.1) {
      take(prior, from, from + 0.1, kBias);
      prior.readings().take(imuAt(kStart, from + 0.1, rateAt(from + 0.1) + kBias));
      Pose T_from_to;
      T_from_to.rotation = truthAt(from).conjugate() * truthAt(from + 0.1);
      if (!is_heading_known) T_from_to.rotation *= expSO3({0.0, 0.0, 0.1 * kBias.z()});
      prior.observe(kStart.plusSeconds(from), kStart.plusSeconds(from + 0.1), T_from_to,
                    information);
    }
  };
  drive(0.0, 20.0, false);
  EXPECT_NEAR(prior.bias().x(), kBias.x(), 1e-3);
  EXPECT_NEAR(prior.bias().z(), 0.0, 1e-4);
  const auto motion = prior.motion(kStart.plusSeconds(19.0), kStart.plusSeconds(20.0));
  ASSERT_TRUE(motion);
  EXPECT_GT(motion->covariance(5, 5), 0.5 * std::pow(PriorsConfig().gyro.initial_bias, 2));
  EXPECT_LT(motion->covariance(3, 3), 0.1 * motion->covariance(5, 5));
  drive(20.0, 30.0, true);
  EXPECT_NEAR(prior.bias().z(), kBias.z(), 1e-3);
}

TEST(GyroPrior, ARegistrationGoneWrongDoesNotMakeABias) {
  GyroPrior prior{PriorsConfig{}};
  take(prior, 0.0, 3.0, Eigen::Vector3d::Zero());
  Pose T_wrong;
  T_wrong.rotation = truthAt(0.0).conjugate() * truthAt(2.5) * expSO3({0.0, 0.0, 1.0});
  prior.observe(kStart, kStart.plusSeconds(2.5), T_wrong, kKnown);
  EXPECT_EQ(prior.bias(), Eigen::Vector3d::Zero());
}

TEST(GyroPrior, TheVarianceOfAMessageIsTaken) {
  PriorsConfig config;
  config.gyro.initial_bias = 0.0;
  GyroPrior prior{config};
  for (int i = 0; i < 21; ++i) {
    ImuReading reading = imuAt(kStart, 0.005 * i, Eigen::Vector3d::Zero());
    reading.turn_rate_variance = 0.04;
    prior.readings().take(reading);
  }
  const double variance = prior.motion(kStart, kStart.plusSeconds(0.1))->covariance(5, 5);
  EXPECT_NEAR(variance, 0.04 * 0.005 * 0.1, 1e-6);
}

}  // namespace
}  // namespace revisit_slam
