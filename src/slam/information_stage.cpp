// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/information_stage.h"

#include <Eigen/LU>

namespace revisit_slam {
namespace {

PoseVerdict verdictOn(const InformedScan& informed) {
  const PoseVerdict verdict = informed.scan->verdict;
  const bool is_weak = !informed.estimate.weak_directions.empty();
  return verdict == PoseVerdict::good && is_weak ? PoseVerdict::weak : verdict;
}

}  // namespace

InformationStage::InformationStage(const InformationConfig& config)
    : config_(config), estimator_(config), motion_covariance_(config) {}

InformedScan InformationStage::inform(const OdometryOutput& odometry, std::size_t waiting) {
  StageClock clock;
  InformedScan informed;
  informed.scan = odometry.scan;
  const bool begins = session_ != informed.scan->id.session;
  if (begins) startSession(informed.scan->id.session);
  motion_covariance_.observe(informed.scan->deskew_error);
  if (waiting > static_cast<std::size_t>(config_.max_waiting)) {
    informed.estimate = last_estimate_;
    informed.source = InformationSource::repeated;
    informed.covariance_motion = motion_covariance_.of(last_estimate_);
  } else if (odometry.problem) {
    estimate(*odometry.problem, informed);
  }
  informed.verdict = verdictOn(informed);
  if (informed.verdict >= PoseVerdict::poor) doubt(informed);
  growCovariance(informed, begins);
  clock.stage("information");
  informed.times = odometry.times;
  for (const auto& time : clock.times()) informed.times.push_back(time);
  return informed;
}

/// What the registration says of a scan that fits badly may be wrong by as much as the prediction;
/// of one that does not fit it says nothing.
void InformationStage::doubt(InformedScan& informed) const {
  const Matrix6& prior = informed.scan->prior_information;
  if (prior.isZero()) return;
  if (informed.verdict == PoseVerdict::lost) {
    informed.source = InformationSource::predicted;
    informed.covariance_motion.setZero();
  }
  informed.covariance_motion += prior.inverse();
  if (last_estimate_.mean_squared_residual <= 0.0) return;  // nothing was estimated: no unit
  informed.estimate.information = motion_covariance_.informationOf(
      informed.covariance_motion, last_estimate_.mean_squared_residual);
}

void InformationStage::startSession(SessionId session) {
  session_ = session;
  motion_covariance_ = MotionCovariance(config_);
  pose_covariance_ = PoseCovariance();
  last_estimate_ = {};
}

void InformationStage::estimate(const RegistrationProblem& problem, InformedScan& informed) {
  arena_.execute([&] { informed.estimate = estimator_.estimate(problem); });
  informed.source = InformationSource::estimated;
  informed.covariance_motion = motion_covariance_.of(informed.estimate);
  last_estimate_ = informed.estimate;
}

void InformationStage::growCovariance(InformedScan& informed, bool begins) {
  const Pose& T_odom_base = informed.scan->T_odom_base;
  if (!begins)
    pose_covariance_.move(T_odom_previous_.inverse() * T_odom_base, informed.covariance_motion);
  T_odom_previous_ = T_odom_base;
  informed.covariance_pose = pose_covariance_.base();
}

void InformationStage::reconfigure(const InformationConfig& config) {
  config_ = config;
  motion_covariance_.reconfigure(config);
  estimator_.setWeakRatio(config.weak_ratio);
}

}  // namespace revisit_slam
