// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "revisit_slam/evaluation/trajectory_match.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

constexpr double kPeriod = 0.1;

inline Stamp stampOf(std::size_t index) {
  return Stamp{1'700'000'000'000'000'000}.plusSeconds(kPeriod * static_cast<double>(index));
}

/// Along x at 10 m/s, one pose every 0.1 s.
inline Trajectory straightDrive(std::size_t poses) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses; ++i)
    trajectory.push_back({stampOf(i), {Eigen::Quaterniond::Identity(), {1.0 * i, 0, 0}}});
  return trajectory;
}

/// Turns, climbs and rolls.
inline Trajectory windingDrive(std::size_t poses) {
  Trajectory trajectory;
  Pose T;
  for (std::size_t i = 0; i < poses; ++i) {
    trajectory.push_back({stampOf(i), T});
    Tangent motion;
    const double t = 0.03 * static_cast<double>(i);
    motion << 1.0, 0.0, 0.1 * std::sin(t), 0.01 * std::cos(t), 0.0, 0.02 * std::sin(0.7 * t);
    T = boxplus(T, motion);
  }
  return trajectory;
}

inline Trajectory moved(const Pose& T, Trajectory trajectory) {
  for (StampedPose& pose : trajectory) pose.T_world_base = T * pose.T_world_base;
  return trajectory;
}

inline TrajectoryMatch matchOf(const Trajectory& estimate, const Trajectory& reference) {
  return matchToReference(PoseInterpolator(estimate), PoseInterpolator(reference));
}

}  // namespace revisit_slam
