// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/evaluation/map_consistency.h"
#include "revisit_slam/priors/prior_account.h"
#include "revisit_slam/types/pose_verdict.h"
#include "revisit_slam/types/scan_account.h"
#include "revisit_slam/types/sensor_account.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// What became of everything that came in.
struct InputSummary {
  ScanAccount account;
  std::map<std::string, PriorAccount> priors;   ///< by sensor
  std::map<std::string, SensorAccount> lidars;  ///< by topic, where several are merged
  std::string time_source;
};

/// What run.json tells. What is not known is left out of it.
struct RunSummary {
  std::vector<Parameter> parameters;
  std::string topic;
  std::string tracked_frame;
  int threads = 0;
  std::optional<InputSummary> input;
  // Of the scans that were registered.
  std::size_t processed = 0;
  std::map<PoseVerdict, std::size_t> verdicts;
  std::map<std::string, std::vector<float>> stage_ms;  ///< floats: one for each scan
  double path_length = 0.0;                            ///< m

  std::optional<double> wall_seconds;    ///< of the whole run, reading the bag included
  double reading_cpu_seconds = 0.0;      ///< of taking messages out of the bag
  std::optional<double> finish_seconds;  ///< from the last scan to the last optimisation
  std::optional<double> memory_mb_per_km;
  std::map<std::string, int> loops;  ///< constraints by origin and state
  /// Revisit map consistency without reference: cells, and RMS in m (mean, standard deviation).
  std::size_t revisited_cells = 0;
  double consistency_mean = 0.0, consistency_deviation = 0.0;
  bool interrupted = false;  ///< not all scans were read
  int optimisations = 0, rejected_optimisations = 0;
  std::optional<int> retroactive_pairs;
};

/// What run.json tells of consistency.
void judge(const MapConsistency& consistency, RunSummary& summary);

/// Writes run.json, whole or not at all. @throws std::runtime_error naming the file.
void writeRunSummary(const std::string& path, const RunSummary& summary);

}  // namespace revisit_slam
