// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/sweep_motion.h"

#include <gtest/gtest.h>

#include "revisit_slam/types/se3.h"

namespace revisit_slam {
namespace {

const Tangent kVelocity = (Tangent() << 3.0, 0.2, -0.1, 0.1, -0.4, 0.8).finished();

TEST(SweepMotion, IsAConstantMotionWhereTheVelocityIsConstant) {
  const ConstantMotion constant(kVelocity);
  std::vector<Pose> poses;
  for (int i = 1; i <= 5; ++i) poses.push_back(constant.after(-0.02 * i));
  const SweepMotion sweep(0.02, poses);
  const Eigen::Vector3f point{8.0f, -5.0f, 1.0f};
  for (const float seconds : {0.0f, -0.013f, -0.02f, -0.077f, -0.1f, -0.15f})  // one beyond
    EXPECT_LT((sweep.carry(seconds, point) - constant.carry(seconds, point)).norm(), 1e-4f)
        << seconds;
}

TEST(SweepMotion, FollowsAVelocityThatChanges) {
  const auto poseAt = [](double t) {
    return Pose{expSO3({0.0, 4.0 * t * t, 0.0}), {2.0 * t + 10.0 * t * t, 0.0, 0.0}};
  };
  std::vector<Pose> poses;
  for (int i = 1; i <= 5; ++i) poses.push_back(poseAt(-0.02 * i));
  const SweepMotion sweep(0.02, poses);
  const Eigen::Vector3d point{20.0, 0.0, 2.0};
  const ConstantMotion mean(-log(poseAt(-0.1)) / 0.1);
  double worst = 0.0, worst_of_mean = 0.0;
  for (double t = 0.0; t >= -0.1; t -= 0.005) {
    const Eigen::Vector3f truth = (poseAt(t) * point).cast<float>();
    const auto error = [&](const auto& motion) {
      return static_cast<double>(
          (motion.carry(static_cast<float>(t), point.cast<float>()) - truth).norm());
    };
    worst = std::max(worst, error(sweep));
    worst_of_mean = std::max(worst_of_mean, error(mean));
  }
  EXPECT_LT(worst, 0.1 * worst_of_mean);
}

}  // namespace
}  // namespace revisit_slam
