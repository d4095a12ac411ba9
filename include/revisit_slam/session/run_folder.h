// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "revisit_slam/evaluation/map_consistency.h"
#include "revisit_slam/io/folder_lock.h"
#include "revisit_slam/io/growing_file.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/priors/prior_account.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/types/scan_account.h"
#include "revisit_slam/types/travelled_distance.h"
#include "revisit_slam/util/parameters.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

/// What run.json tells beside what the folder has seen itself.
struct RunSummary {
  std::vector<Parameter> parameters;
  ScanAccount account;
  std::map<PoseVerdict, std::size_t> verdicts;
  std::map<std::string, PriorAccount> priors;  ///< by sensor
  std::string topic;
  std::string tracked_frame;
  std::string time_source;
  double wall_seconds = 0.0;         ///< of the whole run, reading the bag included
  double reading_cpu_seconds = 0.0;  ///< of taking messages out of the bag
  double finish_seconds = 0.0;       ///< from the last scan to the last optimisation
  double path_length = 0.0;          ///< m
  double memory_mb_per_km = 0.0;
  int threads = 0;
  std::map<std::string, int> loops;  ///< constraints by origin and state
  /// Revisit map consistency without reference: cells, and RMS in m (mean, standard deviation).
  std::size_t revisited_cells = 0;
  double consistency_mean = 0.0, consistency_deviation = 0.0;
  bool interrupted = false;  ///< not all scans were read
  int optimisations = 0, rejected_optimisations = 0, retroactive_pairs = 0;
};

/// What run.json tells of consistency.
void judge(const MapConsistency& consistency, RunSummary& summary);

/// Writes run.json, whole or not at all. `stage_ms`: times of every stage.
/// @throws std::runtime_error naming the file.
void writeRunSummary(const std::string& path, const RunSummary& summary,
                     const std::map<std::string, std::vector<float>>& stage_ms);

/// Lines that are added to a file. Those that cannot be written wait for the next.
class LineFile {
 public:
  explicit LineFile(const std::string& path) : file_(path) {}

  void add(const std::string& line);
  /// @throws std::runtime_error naming the file, if there are lines that cannot be written.
  void flush();

 private:
  GrowingFile file_;
  std::string waiting_;
};

/// The folder that a run leaves behind. Poses and times are on disk as soon as they are known.
class RunFolder {
 public:
  /// Makes the folder with its parents, and locks it. @throws std::runtime_error naming a path that
  /// cannot be made, is in use, or holds results already.
  explicit RunFolder(const std::string& path);

  const std::string& path() const { return path_; }
  const std::shared_ptr<FolderLock>& lock() const { return lock_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// Appends to odometry.tum, odometry_information.csv and scan_times.csv.
  void add(const InformedScan& informed, const StageTimes& times);

  /// Wall time of what is done once for a local map or an optimisation, for run.json.
  void addTimes(const StageTimes& times);

  double pathLength() const { return distance_.metres(); }

  /// Writes run.json, whole or not at all, and lines that wait. @throws std::runtime_error
  void finish(RunSummary summary);

 private:
  void writeInformation(const InformedScan& informed);
  void writeTimes(const RegisteredScan& scan, const StageTimes& times);

  std::string path_;
  std::shared_ptr<FolderLock> lock_;
  LineFile odometry_, information_, scan_times_;
  std::vector<std::string> stages_;                     // in the order of the first scan
  std::map<std::string, std::vector<float>> stage_ms_;  // floats: one for each scan
  std::map<PoseVerdict, std::size_t> verdicts_;
  TravelledDistance distance_;
};

}  // namespace revisit_slam
