// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "revisit_slam/information/information_estimator.h"
#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/input/sweep_assembler.h"
#include "revisit_slam/input/sweep_merger.h"
#include "revisit_slam/odometry/odometry.h"
#include "revisit_slam/priors/gnss_track.h"
#include "revisit_slam/priors/gravity_track.h"
#include "revisit_slam/priors/motion_priors.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/slam/rest_detector.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/slam/stamp_gate.h"
#include "revisit_slam/slam/tilt_check.h"
#include "revisit_slam/types/scan_account.h"

namespace revisit_slam {

/// What the odometry hands to the information stage.
struct OdometryOutput {
  RegisteredScanPtr scan;
  /// The registration, taken out of the map: what the information is estimated from. Null where the
  /// information is switched off, at the first scan, and where the scan does not fit the map.
  std::shared_ptr<const RegistrationProblem> problem;
  StageTimes times;
};

/// From readings to registered scans that carry their registration problem, with an account of
/// everything that was dropped. Readings that hold a part of a sweep are joined first, and
/// those of several sensors merged. A clock that
/// was set back begins a session by itself. Where motion is measured outside, a scan waits until
/// its readings have come, or a later scan is ahead of it by priors/max_wait: what a scan is
/// predicted with depends on stamps, not on who comes first. Positions of GNSS go with later scans.
class OdometryStage {
 public:
  /// Sessions count from `first`. Where the first one goes on from a map, its number follows those
  /// of the map.
  explicit OdometryStage(const SlamConfig& config, SessionId first = {}, KnownMapPtr prior = {});

  struct Result {
    OdometryOutput output;  ///< without scan where the reading was dropped
    std::string rejection;  ///< why
    std::string notice;     ///< of a session, messages or voxels that change with it; else empty
  };

  /// What became of the reading, and of those before that had to wait for it: none, one or more.
  std::vector<Result> process(ScanReading reading);
  /// What became of the scans that waited for this reading.
  std::vector<Result> takeMotion(const MotionReading& reading);
  /// What became of readings that wait, as no further one comes.
  std::vector<Result> flush();

  /// Counts a message that never became a reading. A gap in the stamps is no wonder then.
  void countDropped(const std::string& reason);
  /// Likewise of one that measures motion, by MotionPriors' name of its sensor.
  void countDroppedMotion(const std::string& sensor, const std::string& reason);

  /// The next scan is the first of another session, in an odometry frame of its own; the account
  /// begins anew. `prior`: the map that the session goes on from; null: none.
  void startSession(KnownMapPtr prior = {});

  void reconfigure(const OdometryConfig& config);

  /// Since startSession().
  const ScanAccount& account() const { return account_; }
  const MotionPriors& priors() const { return priors_; }
  /// Of the sensors beside the LiDAR that are connected, by name.
  std::map<std::string, PriorAccount> sensorAccounts() const;
  /// Of several LiDARs, by topic; empty where there is one.
  std::map<std::string, SensorAccount> lidarAccounts() const { return merger_.accounts(); }
  /// Readings that wait for the next, or for measured motion.
  std::size_t held() const {
    return assembler_.held() + merger_.held() + gate_.held() + waiting_.size();
  }
  /// What is unusual about the messages; empty where nothing is.
  const std::string& sweepForm() const { return assembler_.description(); }
  /// Whether that is point times that cannot be.
  bool doubtsTimes() const { return assembler_.doubtsTimes(); }

 private:
  void take(ScanReading reading, bool is_merged, bool is_misplaced, std::vector<Result>& results);
  void process(std::vector<SweepAssembler::Sweep> sweeps, std::vector<Result>& results);
  void process(std::vector<ScanReading> merged, std::vector<Result>& results);
  void process(std::vector<StampGate::Decision> decisions, std::vector<Result>& results);
  void release(bool all, std::vector<Result>& results);
  bool mayGoOn(bool all);
  void registerNext(std::vector<Result>& results);
  Odometry makeOdometry();
  Result registerScan(ScanReading reading);
  void beginSession();
  bool nameScan(RegisteredScan& scan);
  Result reject(const std::string& reason, const std::string& detail = "");
  std::shared_ptr<const RegistrationProblem> gather(const RegisteredScan& scan) const;

  OdometryConfig config_;
  const PriorsConfig priors_config_;
  const double rest_interval_;
  const bool with_information_;
  SessionId session_;
  KnownMapPtr prior_;  // that the session goes on from; null as soon as a scan has told of it
  InformationEstimator information_;
  tbb::task_arena arena_;
  SweepAssembler assembler_;
  SweepMerger merger_;
  std::string said_sweep_form_;
  StampGate gate_;
  MotionPriors priors_;
  GnssTrack gnss_;
  GravityTrack gravity_;
  std::optional<GravityDirection> direction_due_;  // with the next scan of the graph
  Odometry odometry_;
  RestDetector rest_;
  TiltCheck tilt_check_;
  std::uint32_t ids_ = 0;                    // given in the session
  double voxel_size_;                        // m, of the scan before
  std::deque<StampGate::Decision> waiting_;  // to be registered
  std::string silence_;                      // sensors that were given up for the next scan
  ScanAccount account_;
};

}  // namespace revisit_slam
