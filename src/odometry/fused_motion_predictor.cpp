// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/fused_motion_predictor.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace revisit_slam {
namespace {

/// Of a motion of which nothing is known: up to 30 m/s at 10 Hz.
constexpr double kUnknownTranslation = 3.0;  // m
constexpr double kUnknownRotation = 0.5;     // rad

/// A measurement that the registration contradicts gets so many times the variance, scan for scan;
/// one that it confirms gets half of that back. A sensor that is new begins with the most: wheels
/// with a wrong diameter would hold the registration before it could tell.
constexpr double kDistrust = 4.0;
constexpr double kMostDistrust = 100.0;

/// s: a turning body is taken as turning evenly for so long.
constexpr double kSweepStep = 0.02;
/// s: no sweep takes longer, whatever the pause before it.
constexpr double kLongestSweep = 2.0;

Matrix6 symmetric(const Matrix6& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

/// Translation and rotation each for itself: one may fail without the other.
bool isWithin(double gate, const Tangent& deviation, const Matrix6& covariance) {
  for (const Eigen::Index first : {0, 3}) {
    const Eigen::Vector3d d = deviation.segment<3>(first);
    const Eigen::Matrix3d S = covariance.block<3, 3>(first, first);
    if (d.dot(S.inverse() * d) > gate * gate) return false;
  }
  return true;
}

/// The pose minimises both squared deviations, weighed by information.
RegistrationEvidence evidenceOf(const Matrix6& information, const PredictedMotion& predicted) {
  if (!predicted.is_measured) return {information, Matrix6::Identity()};
  return {information, (information + predicted.information).inverse() * information};
}

/// A Kalman update of the covariance P by a measurement, in Joseph's form: after a long pause P is
/// so much larger than the measurement's that a difference of both would have no digit left.
/// @return the gain.
Matrix6 update(const Matrix6& covariance, Matrix6& P) {
  Matrix6 gain = P * (P + covariance).inverse();
  const Matrix6 rest = Matrix6::Identity() - gain;
  P = symmetric(rest * P * rest.transpose() + gain * covariance * gain.transpose());
  return gain;
}

}  // namespace

FusedMotionPredictor::FusedMotionPredictor(const OdometryConfig& config,
                                           std::unique_ptr<MotionPredictor> predictor,
                                           const PriorsConfig& priors_config, MotionPriors& priors)
    : predictor_(std::move(predictor)),
      gate_(priors_config.gate),
      error_scans_(priors_config.odometry.error_scans),
      priors_(priors) {
  reconfigure(config);
}

PredictedMotion FusedMotionPredictor::predict(Stamp stamp) const {
  return fuse(stamp).predicted;
}

Matrix6 FusedMotionPredictor::covarianceOf(const PredictedMotion& predicted) const {
  if (predicted.covariance) return *predicted.covariance;
  Tangent variance;
  variance << Eigen::Vector3d::Constant(kUnknownTranslation * kUnknownTranslation),
      Eigen::Vector3d::Constant(kUnknownRotation * kUnknownRotation);
  return variance.asDiagonal();
}

FusedMotionPredictor::Fusion FusedMotionPredictor::fuse(Stamp stamp) const {
  Fusion fusion;
  PredictedMotion& predicted = fusion.predicted;
  predicted = predictor_->predict(stamp);
  if (!previous_stamp_ || stamp <= *previous_stamp_) return fusion;
  predicted.covariance = covarianceOf(predicted);
  Matrix6 P = *predicted.covariance;  // as the prediction is weighed beside the registration
  for (const MotionPriors::Measurement& measurement : priors_.measure(*previous_stamp_, stamp)) {
    Weighed& weighed = fusion.measurements.emplace_back(Weighed{measurement});
    if (!measurement.motion) continue;
    const MeasuredMotion& motion = *measurement.motion;
    const auto judged = distrust_.find(measurement.sensor);
    const double distrust = judged == distrust_.end() ? kMostDistrust : judged->second;
    weighed.covariance = distrust * motion.covariance;
    const Tangent innovation = log(predicted.T_previous_base.inverse() * motion.T_from_to);
    weighed.is_used = isWithin(gate_, innovation, *predicted.covariance + weighed.covariance);
    if (!weighed.is_used) continue;
    if (measurement.sensor == MotionPriors::kOdometry)
      weighed.error_scans = std::max(1.0, error_scans_ / distrust);
    const Matrix6 gain = update(weighed.covariance / weighed.error_scans, P);
    predicted.T_previous_base = boxplus(predicted.T_previous_base, gain * innovation);
    update(weighed.covariance, *predicted.covariance);
    predicted.is_measured = true;
  }
  if (!predicted.is_measured) return {predictor_->predict(stamp), fusion.measurements};
  predicted.information = P.inverse();
  predicted.velocity = ConstantMotion(log(predicted.T_previous_base) / predicted.seconds);
  predicted.sweep = sweepOf(fusion, stamp);
  return fusion;
}

/// The predicted motion at a constant velocity, and what the sensors have seen that to miss.
SweepMotion FusedMotionPredictor::sweepOf(const Fusion& fusion, Stamp stamp) const {
  const PredictedMotion& predicted = fusion.predicted;
  std::vector<Pose> T_stamp_base;
  const long steps = std::lround(std::min(predicted.seconds, kLongestSweep) / kSweepStep);
  for (long step = 1; step <= steps; ++step) {
    const double seconds = kSweepStep * static_cast<double>(step);
    T_stamp_base.push_back(predicted.velocity.after(-seconds) *
                           unevenness(fusion, stamp, std::min(seconds, predicted.seconds)));
  }
  if (T_stamp_base.empty()) T_stamp_base.push_back(predicted.velocity.after(-kSweepStep));
  return SweepMotion(kSweepStep, T_stamp_base);
}

/// So long before the stamp. Of the gyro the rotation, as that is finer, of the rest all.
Pose FusedMotionPredictor::unevenness(const Fusion& fusion, Stamp stamp, double seconds) const {
  Pose T_even_seen;
  for (const Weighed& weighed : fusion.measurements) {
    if (!weighed.is_used) continue;
    const std::string& sensor = weighed.measurement.sensor;
    const auto seen = priors_.measure(sensor, stamp.plusSeconds(-seconds), stamp);
    if (!seen) continue;
    const Tangent in_all = log(weighed.measurement.motion->T_from_to);
    const Pose T_stamp_even = exp(-seconds / fusion.predicted.seconds * in_all);
    const Pose missed = T_stamp_even.inverse() * seen->T_from_to.inverse();
    if (sensor == MotionPriors::kGyro) {
      T_even_seen.rotation = missed.rotation;
    } else {
      T_even_seen = missed;
    }
  }
  return T_even_seen;
}

void FusedMotionPredictor::observe(Stamp stamp, const Pose& T_odom_base,
                                   const Matrix6& information) {
  Matrix6 information_in_all = information;
  if (previous_stamp_) {
    const Pose T_previous_base = T_odom_previous_.inverse() * T_odom_base;
    const Fusion fusion = fuse(stamp);
    std::set<std::string> rejected;
    for (const Weighed& weighed : fusion.measurements) {
      judge(weighed, T_previous_base, information);
      if (weighed.is_used)
        information_in_all += weighed.covariance.inverse();
      else if (weighed.measurement.motion)
        rejected.insert(weighed.measurement.sensor);
    }
    priors_.observe(*previous_stamp_, stamp, T_previous_base,
                    evidenceOf(information, fusion.predicted), rejected);
  }
  predictor_->observe(stamp, T_odom_base, information_in_all);
  previous_stamp_ = stamp;
  T_odom_previous_ = T_odom_base;
}

/// What the sensors measure from here on counts as before.
void FusedMotionPredictor::forget() {
  previous_stamp_.reset();
  predictor_->forget();
}

/// By the registration, as far as that is constrained.
void FusedMotionPredictor::judge(const Weighed& weighed, const Pose& T_previous_base,
                                 const Matrix6& information) {
  PriorAccount& account = priors_.account(weighed.measurement.sensor);
  if (!weighed.measurement.motion) {
    ++account.missing;
    return;
  }
  ++(weighed.is_used ? account.used : account.rejected);
  const MeasuredMotion& motion = *weighed.measurement.motion;
  Matrix6 weakly_known = information;
  weakly_known.diagonal().array() += 1.0 / kUnmeasured;
  const Tangent error = log(motion.T_from_to.inverse() * T_previous_base);
  double& distrust = distrust_.try_emplace(weighed.measurement.sensor, kMostDistrust).first->second;
  distrust = isWithin(gate_, error, motion.covariance + weakly_known.inverse())
                 ? std::max(1.0, 0.5 * distrust)
                 : std::min(kMostDistrust, kDistrust * distrust);
}

}  // namespace revisit_slam
