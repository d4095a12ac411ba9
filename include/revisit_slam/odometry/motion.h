// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Motion at a constant body velocity: after t seconds the body has moved by Exp(t * velocity).
class ConstantMotion {
 public:
  /// `velocity`: [m/s; rad/s] in the body frame.
  explicit ConstantMotion(const Tangent& velocity = Tangent::Zero());

  const Tangent& velocity() const { return velocity_; }
  Pose after(double seconds) const { return exp(seconds * velocity_); }

  /// What Exp(seconds * velocity) takes of the time alone: points of one instant share it.
  struct Instant {
    float sine, cosine;          // the coefficients of omega x and of omega x omega x, s and s^2
    Eigen::Vector3f t1, t2, t3;  // terms of the translation, m
  };
  Instant at(float seconds) const;

  /// Exp(seconds * velocity) * point, without building the transform: for one time per point.
  Eigen::Vector3f carry(const Instant& instant, const Eigen::Vector3f& point) const {
    const Eigen::Vector3f turned = omega_.cross(point);
    return point + instant.sine * turned + instant.cosine * omega_.cross(turned) + instant.t1 +
           instant.t2 + instant.t3;
  }
  Eigen::Vector3f carry(float seconds, const Eigen::Vector3f& point) const {
    return carry(at(seconds), point);
  }

 private:
  Tangent velocity_;
  float turn_rate_;  // rad/s
  Eigen::Vector3f omega_;
  Eigen::Vector3f v_, omega_v_, omega_omega_v_;
};

}  // namespace revisit_slam
