// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Length of the tangent vector from one pose to the other.
inline double distanceBetween(const Pose& a, const Pose& b) {
  return log(a.inverse() * b).norm();
}

/// Random numbers of one test, the same in every run.
class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  double gaussian(double sigma) { return std::normal_distribution<double>(0.0, sigma)(engine_); }

  /// In the cube [-half, half)^3.
  Eigen::Vector3d inCube(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d v = inCube(1.0);
      if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
  }
  /// With a rotation by exactly `angle`.
  Tangent tangent(double half_translation, double angle) {
    Tangent t;
    t.head<3>() = inCube(half_translation);
    t.tail<3>() = angle * direction();
    return t;
  }
  Pose pose(double half_translation) {
    const Tangent t = tangent(half_translation, uniform(0.0, 3.1));
    return {expSO3(t.tail<3>()), t.head<3>()};
  }
  Points cloud(std::size_t count, double half) {
    Points points(count);
    for (auto& point : points) point = inCube(half).cast<float>();
    return points;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace revisit_slam
