// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/motion.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(ConstantMotion, CarriesPointsAsTheExponentialDoes) {
  RandomNumbers random(1);
  for (const double turn : {0.0, 1e-6, 1e-3, 0.1, 0.499, 0.501, 1.0, 3.0, 6.3, 20.0})
    for (const double seconds : {-1.0, -0.1, -1e-3, 0.0, 0.1, 2.0})
      for (int i = 0; i < 20; ++i) {
        Tangent velocity = random.tangent(30.0, turn);
        if (seconds != 0.0) velocity.tail<3>() /= std::abs(seconds);  // `turn` is the whole turn
        const ConstantMotion motion(velocity);
        const Eigen::Vector3f point = random.inCube(60.0).cast<float>();
        const Eigen::Vector3d expected = exp(seconds * velocity) * point.cast<double>();
        const Eigen::Vector3f carried = motion.carry(static_cast<float>(seconds), point);
        EXPECT_LT((carried.cast<double>() - expected).norm(), 4e-5 * (1.0 + turn))
            << turn << " rad in " << seconds << " s";
      }
}

TEST(ConstantMotion, CarryAgreesWithAfter) {
  Tangent velocity;
  velocity << 10, 1, -0.5, 0.1, -0.2, 0.7;
  const ConstantMotion motion(velocity);
  const Eigen::Vector3f point(40, -30, 5);
  const Eigen::Vector3d expected = motion.after(-0.1) * point.cast<double>();
  EXPECT_LT((motion.carry(-0.1f, point).cast<double>() - expected).norm(), 1e-5);
  EXPECT_EQ(motion.velocity(), velocity);
}

TEST(ConstantMotion, RestLeavesPointsAsTheyAre) {
  const Eigen::Vector3f point(1.1f, -2.2f, 3.3f);
  EXPECT_EQ(ConstantMotion().carry(-0.1f, point), point);
  EXPECT_EQ(ConstantMotion().after(5.0).matrix(), Eigen::Matrix4d::Identity());
}

}  // namespace
}  // namespace revisit_slam
