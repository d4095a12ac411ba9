// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/velocity_filter.h"

#include <Eigen/LU>
#include <algorithm>

namespace revisit_slam {
namespace {

/// Scans over which accelerations are averaged: half a minute at 10 Hz.
constexpr int kMemory = 300;
/// Scans that the initial accelerations count for.
constexpr int kInitialWeight = 10;
/// m/s^2, rad/s^2: any platform may always do so.
constexpr double kLeastAcceleration = 0.3;

Matrix6 symmetric(const Matrix6& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

}  // namespace

VelocityFilter::Prediction VelocityFilter::predict(const Pose& T_previous_base,
                                                   double seconds) const {
  const Matrix6 A = adjoint(T_previous_base.inverse());
  Prediction predicted;
  predicted.change = (seconds * seconds * acceleration_variance_).asDiagonal().toDenseMatrix();
  predicted.velocity = velocity_ + predicted.change;
  const Matrix6 turned = A * pose_velocity_;
  predicted.pose_velocity = turned + seconds * predicted.velocity;
  predicted.pose = symmetric(A * pose_ * A.transpose() + seconds * (turned + turned.transpose() +
                                                                    seconds * predicted.velocity));
  return predicted;
}

Matrix6 VelocityFilter::predictedCovariance(const Pose& T_previous_base, double seconds) const {
  return predict(T_previous_base, seconds).pose;
}

/// With the gain K of the pose, the velocity follows the pose by G = P_vp P_pp^-1: all that is
/// observed of it.
Tangent VelocityFilter::update(const Pose& T_previous_base, double seconds,
                               const Tangent& deviation, const Matrix6& information) {
  const Prediction predicted = predict(T_previous_base, seconds);
  const Matrix6& P = predicted.pose;
  const Matrix6 I = Matrix6::Identity();
  const Matrix6 P_inverse = P.inverse();
  const Matrix6 G = predicted.pose_velocity.transpose() * P_inverse;
  // Of the pose after the registration, (P^-1 + information)^-1, without inverting the latter.
  const Matrix6 posterior = symmetric((I + P * information).fullPivLu().solve(P));
  const Matrix6 C = seconds * predicted.change * P_inverse;  // the change of the velocity, likewise
  learn(C * deviation, predicted.change - C * (P - posterior) * C.transpose(), seconds);
  velocity_ = symmetric(predicted.velocity - G * (P - posterior) * G.transpose());
  // The map goes on from this pose: what the prediction contributed to its error is one of the map
  // to come as well, and only that of the matches will show.
  pose_ = symmetric(posterior * information * posterior);
  pose_velocity_ = pose_ * G.transpose();
  return G * deviation;
}

void VelocityFilter::start(double seconds, const Matrix6& information) {
  const Matrix6 unknown = (acceleration_variance_).asDiagonal();
  pose_ = (information + unknown.inverse()).inverse();
  velocity_ = pose_ / (seconds * seconds);
  pose_velocity_ = pose_ / seconds;
}

void VelocityFilter::learn(const Tangent& change, const Matrix6& covariance, double seconds) {
  const Tangent seen = (change.cwiseAbs2() + covariance.diagonal()) / (seconds * seconds);
  learned_ = std::min(learned_ + 1, kMemory);
  acceleration_variance_ += (seen - acceleration_variance_) / (learned_ + kInitialWeight);
  acceleration_variance_ = acceleration_variance_.cwiseMax(kLeastAcceleration * kLeastAcceleration);
}

}  // namespace revisit_slam
