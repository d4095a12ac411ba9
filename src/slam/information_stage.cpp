// SPDX-License-Identifier: MIT
#include "revisit_slam/slam/information_stage.h"

namespace revisit_slam {

InformationStage::InformationStage(const InformationConfig& config)
    : config_(config), estimator_(config), motion_covariance_(config) {}

InformedScan InformationStage::inform(const OdometryOutput& odometry, std::size_t waiting) {
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
  growCovariance(informed, begins);
  return informed;
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
