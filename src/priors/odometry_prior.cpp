// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/odometry_prior.h"

namespace revisit_slam {
namespace {

/// Clocks that are some milliseconds apart, counts of an encoder, a frame that gives: a motion is
/// not known better, nor is a standstill.
constexpr double kTranslationFloor = 0.003;  // m
constexpr double kRotationFloor = 0.0005;    // rad

double squared(double value) {
  return value * value;
}

}  // namespace

std::optional<MeasuredMotion> OdometryPrior::motion(Stamp from, Stamp to) const {
  const std::optional<OdometryReading> begin = interpolate(from), end = interpolate(to);
  if (!begin || !end) return std::nullopt;
  MeasuredMotion measured;
  measured.T_from_to = begin->T_world_base.inverse() * end->T_world_base;
  measured.covariance = covarianceOf(log(measured.T_from_to), secondsBetween(from, to), *end);
  return measured;
}

/// At a constant velocity between two readings.
std::optional<OdometryReading> OdometryPrior::interpolate(Stamp stamp) const {
  const auto after = readings_.at(stamp);
  if (after == readings_.end()) return std::nullopt;
  if (after->stamp == stamp) return *after;
  if (after == readings_.begin()) return std::nullopt;
  const OdometryReading& before = *std::prev(after);
  const double gap = secondsBetween(before.stamp, after->stamp);
  if (gap > max_gap_) return std::nullopt;
  OdometryReading reading = *after;
  reading.stamp = stamp;
  const double share = secondsBetween(before.stamp, stamp) / gap;
  reading.T_world_base =
      before.T_world_base * exp(share * log(before.T_world_base.inverse() * after->T_world_base));
  return reading;
}

/// An error of the velocity lasts from scan to scan: scales are wrong, wheels slip for a while.
Matrix6 OdometryPrior::covarianceOf(const Tangent& motion, double seconds,
                                    const OdometryReading& end) const {
  const double metres = motion.head<3>().norm(), radians = motion.tail<3>().norm();
  Matrix6 covariance = Matrix6::Zero();
  if (end.velocity_covariance) {
    covariance = squared(seconds) * *end.velocity_covariance;
  } else {
    // Wheels count the way wrong along itself; across it they slip.
    const Eigen::Vector3d along = motion.head<3>();
    const double across = squared(noise_.slip_per_metre);
    covariance.topLeftCorner<3, 3>() =
        (squared(noise_.translation_per_metre) - across) * along * along.transpose();
    covariance.diagonal().head<3>().array() +=
        across * squared(metres) + squared(noise_.translation_per_radian * radians);
    covariance.diagonal().tail<3>().setConstant(squared(noise_.rotation_per_metre * metres) +
                                                squared(noise_.rotation_per_radian * radians));
  }
  covariance.diagonal().head<3>().array() += squared(kTranslationFloor);
  covariance.diagonal().tail<3>().array() += squared(kRotationFloor);
  if (end.is_planar)
    for (const int axis : {2, 3, 4}) covariance(axis, axis) += kUnmeasured;
  return covariance;
}

}  // namespace revisit_slam
