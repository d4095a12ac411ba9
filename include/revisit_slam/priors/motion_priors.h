// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "revisit_slam/priors/gyro_prior.h"
#include "revisit_slam/priors/odometry_prior.h"
#include "revisit_slam/priors/prior_account.h"

namespace revisit_slam {

/// The sensors outside that measure the motion of the base, with an account of each. Which readings
/// a scan is given depends on stamps alone, so that live and offline agree.
class MotionPriors {
 public:
  explicit MotionPriors(const PriorsConfig& config);

  static constexpr const char* kOdometry = "odometry";
  static constexpr const char* kGyro = "gyro";

  bool isConnected() const { return !accounts_.empty(); }

  void take(const MotionReading& reading);
  /// Of a message that never became a reading.
  void countDropped(const std::string& sensor, const std::string& reason);

  /// Whether every sensor that is not silent has readings up to the stamp.
  bool reach(Stamp stamp) const;
  /// No scan waits for sensors that have not reached the stamp, until they are up with the scans
  /// again. Returns their names.
  std::string giveUp(Stamp stamp);

  struct Measurement {
    std::string sensor;
    std::optional<MeasuredMotion> motion;
  };
  /// One for each sensor that is connected.
  std::vector<Measurement> measure(Stamp from, Stamp to) const;

  /// Likewise of one sensor.
  std::optional<MeasuredMotion> measure(const std::string& sensor, Stamp from, Stamp to) const;

  /// The scan at the stamp `to` is registered. What a sensor of `rejected` measured contradicted
  /// the prediction: it is no evidence on its scale or bias.
  void observe(Stamp from, Stamp to, const Pose& T_from_to, const RegistrationEvidence& evidence,
               const std::set<std::string>& rejected = {});
  PriorAccount& account(const std::string& sensor) { return accounts_.at(sensor); }
  const std::map<std::string, PriorAccount>& accounts() const { return accounts_; }

  /// Another session: the accounts begin anew. Readings stay: the sensors go on.
  void restart();

 private:
  bool reaches(const std::string& sensor, Stamp stamp) const;

  OdometryPrior odometry_;
  GyroPrior gyro_;
  std::map<std::string, PriorAccount> accounts_;  // of the sensors that are connected
  std::optional<Stamp> newest_scan_;              // that went on
};

}  // namespace revisit_slam
