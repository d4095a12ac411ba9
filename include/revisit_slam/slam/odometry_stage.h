// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <memory>
#include <string>

#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/odometry/odometry.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/scan_account.h"

namespace revisit_slam {

/// What the odometry hands to the information stage.
struct OdometryOutput {
  RegisteredScanPtr scan;
  /// The registration, taken out of the map: what the information is estimated from. Null where the
  /// information is switched off, and at the first scan.
  std::shared_ptr<const RegistrationProblem> problem;
};

/// From readings to registered scans that carry their registration problem, with an account of
/// everything that was dropped.
class OdometryStage {
 public:
  /// Sessions count from `first`.
  explicit OdometryStage(const SlamConfig& config, SessionId first = {});

  struct Result {
    OdometryOutput output;  ///< without scan where the reading was dropped
    std::string rejection;  ///< why
    StageTimes times;
  };

  Result process(ScanReading reading);

  /// Counts a message that never became a reading.
  void countDropped(const std::string& reason);

  /// The next scan is the first of another session, in an odometry frame of its own.
  void startSession();

  void reconfigure(const OdometryConfig& config);

  /// Of the session.
  const ScanAccount& account() const { return account_; }

 private:
  Result reject(const char* reason, const std::string& detail);
  std::shared_ptr<const RegistrationProblem> gather(const RegisteredScan& scan) const;

  OdometryConfig config_;
  bool with_information_;
  SessionId session_;
  InformationEstimator information_;
  tbb::task_arena arena_;
  Odometry odometry_;
  ScanAccount account_;
};

}  // namespace revisit_slam
