// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/adaptive_threshold.h"

#include <gtest/gtest.h>

#include <cmath>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

TEST(AdaptiveThreshold, IsTheRootMeanSquareOfDeviationsAndTheInitialValue) {
  AdaptiveThreshold threshold({2.0, 0.1}, 50.0);
  EXPECT_DOUBLE_EQ(threshold.sigma(), 2.0);
  double sum = 4.0;
  int samples = 1;
  for (const double angle : {0.0, 0.02, -0.3, 3.0}) {
    const Pose deviation{expSO3(angle * Eigen::Vector3d(2, 1, -2) / 3.0), {0.3, -0.4, 1.2}};
    const double error = 1.3 + 2.0 * 50.0 * std::sin(0.5 * std::abs(angle));
    threshold.update(deviation);
    sum += error * error;
    EXPECT_NEAR(threshold.sigma(), std::sqrt(sum / ++samples), 1e-12);
  }
}

TEST(AdaptiveThreshold, ShrinksWithGoodPredictions) {
  AdaptiveThreshold threshold({2.0, 0.1}, 50.0);
  for (int i = 0; i < 999; ++i) threshold.update({Eigen::Quaterniond::Identity(), {0.2, 0, 0}});
  EXPECT_NEAR(threshold.sigma(), std::sqrt((4.0 + 999 * 0.04) / 1000), 1e-12);
}

TEST(AdaptiveThreshold, DeviationsUpToTheMinimumMotionDoNotCount) {
  AdaptiveThreshold threshold({2.0, 0.25}, 100.0);
  threshold.update(Pose::identity());
  threshold.update({Eigen::Quaterniond::Identity(), {0.25, 0, 0}});
  threshold.update({expSO3({0.002, 0, 0}), Eigen::Vector3d::Zero()});
  EXPECT_DOUBLE_EQ(threshold.sigma(), 2.0);
  threshold.update({expSO3({0.002, 0, 0}), {0.06, 0, 0}});
  EXPECT_LT(threshold.sigma(), 1.5);
}

}  // namespace
}  // namespace revisit_slam
