// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "revisit_slam/io/line_file.h"
#include "revisit_slam/session/run_summary.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/types/loop_candidate.h"
#include "revisit_slam/types/travelled_distance.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

/// What a scan adds to the log of a drive: all but its points.
struct DriveLogEntry {
  ScanId scan;
  StampedPose pose;  ///< T_odom_base
  InformationSource source;
  double mean_squared_residual;
  std::size_t weak_directions;
  Matrix6 information, covariance_motion;
  PoseVerdict verdict;
  double explained;
  double jump;
  StageTimes times;
};

/// `times`: of all stages.
DriveLogEntry entryOf(const InformedScan& informed, const StageTimes& times);

/// What is known of each scan of a drive, on disk as soon as it is known: odometry.tum,
/// odometry_information.csv and scan_times.csv in a folder; and loop_candidates.csv, once a pair of
/// submaps was registered.
class DriveLog {
 public:
  explicit DriveLog(const std::string& folder);

  void add(const DriveLogEntry& entry);
  /// May be called in another thread than the rest, and not while flush() is.
  void add(const LoopCandidate& candidate);
  /// Wall time of what is done once for a local map or an optimisation, for run.json.
  void addTimes(const StageTimes& times);

  double pathLength() const { return distance_.metres(); }

  void tell(RunSummary& summary) const;
  /// Writes lines that wait. @throws std::runtime_error naming the file that cannot be written.
  void flush();

 private:
  void writeInformation(const DriveLogEntry& entry);
  void writeTimes(const DriveLogEntry& entry);

  LineFile odometry_, information_, scan_times_, loop_candidates_;
  std::vector<std::string> stages_;  // columns of scan_times_: those of the first scan
  std::map<std::string, std::vector<float>> stage_ms_;
  std::map<PoseVerdict, std::size_t> verdicts_;
  TravelledDistance distance_;
};

}  // namespace revisit_slam
