// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/motion.h"

#include <cmath>

namespace revisit_slam {
namespace {

/// sin(x)/x, (1 - cos(x))/x^2 and (x - sin(x))/x^3: the coefficients of the exponential of SE(3).
struct ScrewCoefficients {
  float a, b, c;
};

ScrewCoefficients screwCoefficients(float angle) {
  const float x = angle * angle;
  if (x < 0.25f) {  // the next terms are below 1e-8
    return {1.0f - x / 6.0f * (1.0f - x / 20.0f * (1.0f - x / 42.0f)),
            0.5f - x / 24.0f * (1.0f - x / 30.0f * (1.0f - x / 56.0f)),
            1.0f / 6.0f - x / 120.0f * (1.0f - x / 42.0f * (1.0f - x / 72.0f))};
  }
  const float sine = std::sin(angle);
  return {sine / angle, (1.0f - std::cos(angle)) / x, (angle - sine) / (x * angle)};
}

}  // namespace

ConstantMotion::ConstantMotion(const Tangent& velocity)
    : velocity_(velocity),
      turn_rate_(static_cast<float>(velocity.tail<3>().norm())),
      omega_(velocity.tail<3>().cast<float>()),
      v_(velocity.head<3>().cast<float>()),
      omega_v_(omega_.cross(v_)),
      omega_omega_v_(omega_.cross(omega_v_)) {}

ConstantMotion::Instant ConstantMotion::at(float seconds) const {
  const ScrewCoefficients k = screwCoefficients(seconds * turn_rate_);
  const float t1 = seconds, t2 = t1 * seconds, t3 = t2 * seconds;
  return {k.a * t1, k.b * t2, t1 * v_, (k.b * t2) * omega_v_, (k.c * t3) * omega_omega_v_};
}

}  // namespace revisit_slam
