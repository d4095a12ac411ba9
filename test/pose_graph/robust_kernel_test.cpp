// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/robust_kernel.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace revisit_slam {
namespace {

TEST(RobustKernel, GemanMcClureIsBoundedWithRightDerivatives) {
  const GemanMcClureLoss loss(3.0);
  double rho[3], up[3], down[3];
  for (const double s : {0.1, 1.0, 9.0, 100.0}) {
    constexpr double kStep = 1e-5;
    loss.Evaluate(s, rho);
    loss.Evaluate(s + kStep, up);
    loss.Evaluate(s - kStep, down);
    EXPECT_NEAR((up[0] - down[0]) / (2 * kStep), rho[1], 1e-9);
    EXPECT_NEAR((up[1] - down[1]) / (2 * kStep), rho[2], 1e-9);
  }
  loss.Evaluate(1e12, rho);
  EXPECT_NEAR(rho[0], 9.0, 1e-6);
  EXPECT_LT(rho[1], 1e-20);
}

TEST(RobustKernel, AllTrustSmallResiduals) {
  for (const char* name : {"huber", "cauchy", "geman_mcclure"}) {
    double rho[3];
    makeLoss({kernelTypeOf(name), 2.0})->Evaluate(1e-8, rho);
    EXPECT_NEAR(rho[0], 1e-8, 1e-15) << name;
    EXPECT_NEAR(rho[1], 1.0, 1e-7) << name;
  }
  EXPECT_EQ(makeLoss({kernelTypeOf("none"), 1.0}), nullptr);
  EXPECT_THROW(kernelTypeOf("tukey"), std::invalid_argument);
}

}  // namespace
}  // namespace revisit_slam
