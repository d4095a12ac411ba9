// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/gyro_prior.h"

#include <Eigen/LU>
#include <algorithm>

namespace revisit_slam {
namespace {

constexpr double kWindow = 2.0;                  // s
constexpr double kRegistrationDeviation = 2e-3;  // rad, of a registered rotation
constexpr double kRotationFloor = 1e-4;          // rad: scale errors and axes that are askew

double squared(double value) {
  return value * value;
}

/// Of a registered rotation about each axis, rad^2.
Eigen::Vector3d rotationVariance(const Matrix6& information) {
  Matrix6 weakly_known = information;
  weakly_known.diagonal().array() += 1.0 / kUnmeasured;
  return weakly_known.inverse().diagonal().tail<3>();
}

}  // namespace

GyroPrior::GyroPrior(const PriorsConfig& config)
    : noise_(config.gyro),
      max_gap_(config.max_gap),
      gate_(config.gate),
      bias_variance_(Eigen::Vector3d::Constant(squared(config.gyro.initial_bias))) {}

std::optional<MeasuredMotion> GyroPrior::motion(Stamp from, Stamp to) const {
  const std::optional<Eigen::Quaterniond> rotation = integrate(from, to);
  if (!rotation) return std::nullopt;
  const double seconds = secondsBetween(from, to);
  MeasuredMotion measured;
  measured.T_from_to.rotation = *rotation;
  measured.covariance *= kUnmeasured;
  measured.covariance.diagonal().tail<3>() =
      squared(seconds) * bias_variance_ +
      Eigen::Vector3d::Constant(noiseVariance(to, seconds) + squared(kRotationFloor));
  return measured;
}

/// From reading to reading with the mean of both turn rates, which at the ends are interpolated.
std::optional<Eigen::Quaterniond> GyroPrior::integrate(Stamp from, Stamp to) const {
  auto after = readings_.at(from);
  if (after == readings_.end() || !readings_.reaches(to)) return std::nullopt;
  if (after == readings_.begin() && after->stamp != from) return std::nullopt;
  const auto rateAt = [](const ImuReading& a, const ImuReading& b, Stamp stamp) {
    const double share = secondsBetween(a.stamp, stamp) / secondsBetween(a.stamp, b.stamp);
    return Eigen::Vector3d(a.turn_rate + share * (b.turn_rate - a.turn_rate));
  };
  if (after->stamp == from) ++after;  // the first segment ends after `from`
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (Stamp begin = from; begin < to; ++after) {
    const ImuReading &a = *std::prev(after), &b = *after;
    if (secondsBetween(a.stamp, b.stamp) > max_gap_) return std::nullopt;
    const Stamp end = std::min(b.stamp, to);
    const Eigen::Vector3d rate = 0.5 * (rateAt(a, b, begin) + rateAt(a, b, end)) - bias_;
    rotation = (rotation * expSO3(secondsBetween(begin, end) * rate)).normalized();
    begin = end;
  }
  return rotation;
}

/// White noise adds up as a random walk; a message tells that of one sample.
double GyroPrior::noiseVariance(Stamp to, double seconds) const {
  const auto last = readings_.at(to);
  if (!last->turn_rate_variance) return squared(noise_.noise_density) * seconds;
  return *last->turn_rate_variance * secondsBetween(std::prev(last)->stamp, last->stamp) * seconds;
}

void GyroPrior::observe(Stamp from, Stamp to, const Pose& T_from_to, const Matrix6& information) {
  const std::optional<Eigen::Quaterniond> rotation = integrate(from, to);
  if (!rotation) return skip();
  window_.seconds += secondsBetween(from, to);
  window_.variance = window_.variance.cwiseMax(rotationVariance(information));
  window_.measured = (window_.measured * *rotation).normalized();
  window_.registered = (window_.registered * T_from_to.rotation).normalized();
  if (window_.seconds < kWindow) return;
  estimateBias(noiseVariance(to, window_.seconds));
  window_ = {};
}

/// A Kalman update of each axis. What is beyond the gate is a registration gone wrong.
void GyroPrior::estimateBias(double noise_variance) {
  const double seconds = window_.seconds;
  bias_variance_.array() += squared(noise_.bias_walk) * seconds;
  const Eigen::Vector3d error = logSO3(window_.registered.conjugate() * window_.measured) / seconds;
  const Eigen::Vector3d of_registrations =
      2.0 * (window_.variance.array() + squared(kRegistrationDeviation));
  const Eigen::Vector3d expected =
      bias_variance_.array() + (of_registrations.array() + noise_variance) / squared(seconds);
  if ((error.array().square() > squared(gate_) * expected.array()).any()) return;
  const Eigen::Vector3d gain = bias_variance_.cwiseQuotient(expected);
  bias_ += gain.cwiseProduct(error);
  bias_variance_ -= gain.cwiseProduct(bias_variance_);
}

}  // namespace revisit_slam
