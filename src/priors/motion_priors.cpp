// SPDX-License-Identifier: MIT
#include "revisit_slam/priors/motion_priors.h"

namespace revisit_slam {

MotionPriors::MotionPriors(const PriorsConfig& config) : odometry_(config), gyro_(config) {
  if (!config.odometry_topic.empty() && !config.odometry_frame.empty())
    throw ParameterError("priors/odometry_topic '" + config.odometry_topic +
                         "' and priors/odometry_frame '" + config.odometry_frame +
                         "' name two odometries: leave one of them empty");
  if (!config.odometry_topic.empty() || !config.odometry_frame.empty()) accounts_[kOdometry];
  if (!config.imu_topic.empty()) accounts_[kGyro];
}

void MotionPriors::take(const MotionReading& reading) {
  const auto* odometry = std::get_if<OdometryReading>(&reading);
  PriorAccount& account = accounts_.at(odometry != nullptr ? kOdometry : kGyro);
  ++account.received;
  const char* reason = odometry != nullptr ? odometry_.readings().take(*odometry)
                                           : gyro_.readings().take(std::get<ImuReading>(reading));
  if (reason != nullptr) {
    ++account.dropped[reason];
    return;
  }
  const Stamp stamp = std::visit([](const auto& any) { return any.stamp; }, reading);
  if (!newest_scan_ || stamp >= *newest_scan_) account.is_silent = false;
}

void MotionPriors::countDropped(const std::string& sensor, const std::string& reason) {
  PriorAccount& account = accounts_.at(sensor);
  ++account.received;
  ++account.dropped[reason];
}

bool MotionPriors::reaches(const std::string& sensor, Stamp stamp) const {
  return sensor == kOdometry ? odometry_.readings().reaches(stamp)
                             : gyro_.readings().reaches(stamp);
}

bool MotionPriors::reach(Stamp stamp) const {
  for (const auto& [sensor, account] : accounts_)
    if (!account.is_silent && !reaches(sensor, stamp)) return false;
  return true;
}

std::string MotionPriors::giveUp(Stamp stamp) {
  newest_scan_ = stamp;
  std::string silent;
  for (auto& [sensor, account] : accounts_) {
    if (account.is_silent || reaches(sensor, stamp)) continue;
    account.is_silent = true;
    silent += (silent.empty() ? "" : ", ") + sensor;
  }
  return silent;
}

std::vector<MotionPriors::Measurement> MotionPriors::measure(Stamp from, Stamp to) const {
  std::vector<Measurement> measurements;
  for (const char* sensor : {kOdometry, kGyro})
    if (accounts_.count(sensor) > 0) measurements.push_back({sensor, measure(sensor, from, to)});
  return measurements;
}

std::optional<MeasuredMotion> MotionPriors::measure(const std::string& sensor, Stamp from,
                                                    Stamp to) const {
  return sensor == kOdometry ? odometry_.motion(from, to) : gyro_.motion(from, to);
}

void MotionPriors::observe(Stamp from, Stamp to, const Pose& T_from_to,
                           const RegistrationEvidence& evidence,
                           const std::set<std::string>& rejected) {
  newest_scan_ = to;
  if (rejected.count(kOdometry) > 0)
    odometry_.skip();
  else
    odometry_.observe(from, to, T_from_to, evidence);
  if (accounts_.count(kOdometry) > 0) account(kOdometry).scale = odometry_.scale();
  if (rejected.count(kGyro) > 0)
    gyro_.skip();
  else
    gyro_.observe(from, to, T_from_to, evidence.information);
  if (accounts_.count(kGyro) > 0) account(kGyro).bias = gyro_.bias();
  odometry_.readings().forgetBefore(to);
  gyro_.readings().forgetBefore(to);
}

void MotionPriors::restart() {
  newest_scan_.reset();
  for (auto& [sensor, account] : accounts_) {
    const bool is_silent = account.is_silent;
    account = {};
    account.is_silent = is_silent;
  }
}

}  // namespace revisit_slam
