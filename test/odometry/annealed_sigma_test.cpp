// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/annealed_sigma.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

RegistrationConfig config() {
  RegistrationConfig config;
  config.convergence = 1e-3;
  config.final_sigma = 0.2;
  return config;
}

TEST(AnnealedSigma, HalvesWhereIcpHasConvergedDownToTheFinalSigma) {
  AnnealedSigma sigma(0.6, config());
  EXPECT_FALSE(sigma.hasConverged(0.02));
  EXPECT_EQ(sigma.value(), 0.6);
  EXPECT_FALSE(sigma.isReduced());
  EXPECT_FALSE(sigma.hasConverged(5e-3));  // ten times longer than at the end
  EXPECT_EQ(sigma.value(), 0.3);
  EXPECT_TRUE(sigma.isReduced());
  EXPECT_FALSE(sigma.hasConverged(5e-3));
  EXPECT_EQ(sigma.value(), 0.2);
  EXPECT_FALSE(sigma.hasConverged(5e-3));
  EXPECT_TRUE(sigma.hasConverged(5e-4));
  EXPECT_EQ(sigma.value(), 0.2);
}

TEST(AnnealedSigma, StaysWhereItIsSmallFromTheBeginning) {
  AnnealedSigma sigma(0.1, config());
  EXPECT_FALSE(sigma.hasConverged(5e-3));
  EXPECT_TRUE(sigma.hasConverged(5e-4));
  EXPECT_EQ(sigma.value(), 0.1);
  EXPECT_FALSE(sigma.isReduced());
}

}  // namespace
}  // namespace revisit_slam
