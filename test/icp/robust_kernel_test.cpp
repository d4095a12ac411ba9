// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/robust_kernel.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

TEST(GemanMcClure, HasKnownValues) {
  const GemanMcClure kernel = GemanMcClure::ofScale(2.0);
  EXPECT_EQ(kernel.weight(0.0), 1.0);
  EXPECT_EQ(kernel.rho(0.0), 0.0);
  EXPECT_DOUBLE_EQ(kernel.weight(4.0), 0.25);  // at s = k^2
  EXPECT_DOUBLE_EQ(kernel.rho(4.0), 2.0);
  EXPECT_NEAR(kernel.rho(1e9), 4.0, 1e-6);  // k^2 is the most
}

TEST(GemanMcClure, ItsWeightIsTheDerivative) {
  const GemanMcClure kernel = GemanMcClure::ofScale(0.7);
  const double h = 1e-6;
  for (const double s : {0.01, 0.1, 0.49, 1.0, 20.0})
    EXPECT_NEAR(kernel.weight(s), (kernel.rho(s + h) - kernel.rho(s - h)) / (2.0 * h), 1e-8) << s;
}

TEST(GemanMcClure, SquaredScaleIsTheSigmaOfKissIcp) {
  const double sigma = 0.3;
  for (const double s : {0.0, 0.02, 0.3, 5.0}) {
    const double kiss = sigma / (sigma + s);
    EXPECT_EQ(GemanMcClure::ofSquaredScale(sigma).weight(s), kiss * kiss) << s;
  }
  EXPECT_EQ(GemanMcClure::ofScale(0.5).weight(0.1), GemanMcClure::ofSquaredScale(0.25).weight(0.1));
}

TEST(TruncatedQuadratic, IsTheSquareUpToTau) {
  const TruncatedQuadratic kernel(1.5);
  EXPECT_EQ(kernel.rho(0.0f), 0.0f);
  EXPECT_EQ(kernel.rho(2.0f), 2.0f);
  EXPECT_EQ(kernel.rho(2.25f), 2.25f);
  EXPECT_EQ(kernel.rho(100.0f), 2.25f);
}

}  // namespace
}  // namespace revisit_slam
