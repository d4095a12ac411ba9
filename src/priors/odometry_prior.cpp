// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/odometry_prior.h"

#include <Eigen/LU>

#include "revisit_slam/priors/covariance_check.h"

namespace revisit_slam {
namespace {

/// Clocks that are some milliseconds apart, counts of an encoder, a frame that gives: a motion is
/// not known better, nor is a standstill.
constexpr double kTranslationFloor = 0.003;  // m
constexpr double kRotationFloor = 0.0005;    // rad

/// Ways over which the scale is compared.
constexpr double kWindow = 2.0;                   // s
constexpr double kShortestWay = 1.0;              // m
constexpr double kRegistrationDeviation = 0.015;  // m, of a registered position

double squared(double value) {
  return value * value;
}

/// Of a registered position in a direction, m^2.
double varianceAlong(const Eigen::Vector3d& direction, const Matrix6& information) {
  Matrix6 weakly_known = information;
  weakly_known.diagonal().array() += 1.0 / kUnmeasured;
  return direction.dot(weakly_known.inverse().topLeftCorner<3, 3>() * direction);
}

}  // namespace

OdometryPrior::OdometryPrior(const PriorsConfig& config)
    : noise_(config.odometry),
      max_gap_(config.max_gap),
      gate_(config.gate),
      scale_variance_(squared(config.odometry.initial_scale_error)) {}

std::optional<MeasuredMotion> OdometryPrior::motion(Stamp from, Stamp to) const {
  const std::optional<Pose> T_from_to = measure(from, to);
  if (!T_from_to) return std::nullopt;
  MeasuredMotion measured;
  measured.T_from_to = *T_from_to;
  measured.T_from_to.translation *= scale_;
  measured.covariance =
      covarianceOf(log(measured.T_from_to), secondsBetween(from, to), *interpolate(to));
  return measured;
}

/// With the scale as it comes.
std::optional<Pose> OdometryPrior::measure(Stamp from, Stamp to) const {
  const std::optional<OdometryReading> begin = interpolate(from), end = interpolate(to);
  if (!begin || !end) return std::nullopt;
  return begin->T_world_base.inverse() * end->T_world_base;
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

void OdometryPrior::observe(Stamp from, Stamp to, const Pose& T_from_to,
                            const RegistrationEvidence& evidence) {
  const std::optional<Pose> measured = measure(from, to);
  if (!measured) return skip();
  window_.seconds += secondsBetween(from, to);
  const double metres = measured->translation.norm();
  if (metres > kTranslationFloor) {
    const Eigen::Vector3d along = measured->translation / metres;
    const Eigen::Vector3d along_to = T_from_to.rotation.conjugate() * along;
    const double deviation = along.dot(T_from_to.translation) - scale_ * metres;
    window_.measured += metres;
    window_.deviation += deviation;
    window_.variance += noise_.error_scans * varianceAlong(along_to, evidence.information);
    window_.share += metres * along_to.dot(evidence.share.topLeftCorner<3, 3>() * along_to);
  }
  if (window_.seconds < kWindow) return;
  if (window_.measured > kShortestWay) estimateScale();
  window_ = {};
}

/// A Kalman update; slip lasts for all of the window. What is beyond the gate is more than that, or
/// a registration gone wrong. Of a wrong scale the pose shows at least the share that the
/// registration has in it: no more is known afterwards than by that, and no more is corrected than
/// the pose shows.
void OdometryPrior::estimateScale() {
  scale_variance_ += squared(noise_.scale_walk) * window_.measured;
  const double error = window_.deviation / window_.measured;
  const double of_ways =
      (window_.variance + 2.0 * squared(kRegistrationDeviation)) / squared(window_.measured) +
      squared(noise_.translation_per_metre);
  const double share = window_.share / window_.measured;
  const double variance = of_ways / squared(share);
  if (squared(error) > squared(gate_) * (variance + scale_variance_)) return;
  const double gain = scale_variance_ / (scale_variance_ + variance);
  scale_ += gain * error;
  scale_variance_ *= 1.0 - gain * share;
}

/// An error of the velocity lasts from scan to scan: wheels slip for a while.
Matrix6 OdometryPrior::covarianceOf(const Tangent& motion, double seconds,
                                    const OdometryReading& end) const {
  const double metres = motion.head<3>().norm(), radians = motion.tail<3>().norm();
  Matrix6 covariance = Matrix6::Zero();
  if (end.velocity_covariance) {
    covariance = squared(seconds) * withPossibleCorrelations(*end.velocity_covariance);
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
  covariance.topLeftCorner<3, 3>() +=
      scale_variance_ * motion.head<3>() * motion.head<3>().transpose();
  covariance.diagonal().head<3>().array() += squared(kTranslationFloor);
  covariance.diagonal().tail<3>().array() += squared(kRotationFloor);
  if (end.is_planar)
    for (const int axis : {2, 3, 4}) covariance(axis, axis) += kUnmeasured;
  return covariance;
}

}  // namespace revisit_slam
