// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/body_motion.h"

#include <cmath>

#include "revisit_slam/simulation/random.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kDegree = kTwoPi / 360.0;
constexpr double kStepsPerSecond = 1.8;

Pose poseOf(double left, double up, double roll, double pitch, double yaw) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const Eigen::Quaterniond rotation = AngleAxisd(yaw, Vector3d::UnitZ()) *
                                      AngleAxisd(pitch, Vector3d::UnitY()) *
                                      AngleAxisd(roll, Vector3d::UnitX());
  return {rotation, {0.0, left, up}};
}

Pose springs(std::uint64_t seed, double time, double strength) {
  const auto noise = [&](std::uint64_t axis, double frequency) {
    return strength * layeredNoise(seed + 8000 + 10 * axis, frequency * time, 0.5, 2);
  };
  return poseOf(0.004 * noise(0, 1.0), 0.012 * noise(1, 2.0), 0.35 * kDegree * noise(2, 1.6),
                0.35 * kDegree * noise(3, 2.0), 0.1 * kDegree * noise(4, 0.8));
}

Pose gait(std::uint64_t seed, double time, double strength) {
  const auto noise = [&](std::uint64_t axis, double frequency) {
    return layeredNoise(seed + 8500 + 10 * axis, frequency * time, 0.5, 2);
  };
  const double phase = kTwoPi * (0.5 * kStepsPerSecond * time + 0.15 * noise(0, 0.3));
  const double left = strength * 0.035 * std::sin(phase) + 0.01 * noise(1, 0.5);
  const double up = strength * 0.025 * std::cos(2.0 * phase) + 0.005 * noise(2, 0.7);
  const double roll = strength * 1.5 * std::sin(phase + 0.4) + 1.5 * noise(3, 0.4);
  const double pitch = strength * 1.2 * std::sin(2.0 * phase + 0.9) + 2.0 * noise(4, 0.4);
  const double yaw = strength * 3.0 * std::sin(phase + 1.3) + 9.0 * noise(5, 0.25);
  return poseOf(left, up, kDegree * roll, kDegree * pitch, kDegree * yaw);
}

}  // namespace

Pose bodyMotion(MotionKind kind, std::uint64_t seed, double time, double speed) {
  if (kind == MotionKind::kHandheld) return gait(seed, time, std::tanh(speed * speed));
  return springs(seed, time, std::tanh(0.03 * speed * speed));
}

}  // namespace revisit_slam::simulation
