// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "localized_drive.h"
#include "revisit_slam/ros/input/motion_reader.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/ros/input/scan_source.h"
#include "revisit_slam/session/run_folder.h"
#include "revisit_slam/slam/slam.h"
#include "revisit_slam/slam/verdict_notice.h"
#include "revisit_slam/util/progress.h"

namespace revisit_slam {

/// Which of the scans of a recording are used.
struct OfflineExtent {
  std::size_t first_scan = 0;
  std::size_t max_scans = 0;  ///< 0: all that follow
};

/// Maps recorded scans as fast as the machine allows and leaves a folder of results, going on from
/// the map of earlier sessions if there is one; or localizes them, where localization/map names a
/// session.
class OfflineRun : private SlamObserver {
 public:
  OfflineRun(const SlamConfig& config, std::unique_ptr<ScanSource> source,
             const std::string& folder, OfflineExtent extent, bool quiet,
             const KnownMapPtr& prior = {});

  void run();

 private:
  void placeSensors();
  void placeSensor(std::size_t sensor);
  void processAll();
  void process(const ScanMessage& message);
  void process(const MotionMessage& message);
  void sayPriors();
  void sayLidars();
  void insert(ScanReading reading, std::size_t sensor, StageClock clock);
  void finishMaps();
  void sayTimeSource();
  SessionTarget targetOf(SessionId session) const;
  void sayWhetherJoined(const GraphSession& session);
  void exportMaps(GraphSession& session);
  void sayWhatWaits();
  void writeResults();
  void judgeConsistency(RunSummary& summary);
  std::optional<double> memoryPerKilometre() const;

  void onScan(const InformedScan& informed, const StageTimes& times) override;
  void onRejection(const std::string& reason) override;
  void onNotice(const std::string& notice) override { progress_.say(notice); }
  void onMaps(const MapUpdate& update) override;
  void onLoopSearch(const LoopSearchResult& result) override;
  void onCorrection(const MapCorrectionPtr& correction) override;
  void onSession(GraphSession& session) override;

  using Clock = std::chrono::steady_clock;
  /// Memory held after a local map was closed, and where on the way that was.
  struct MemoryMark {
    double path_length = 0.0;  // m
    double megabytes = 0.0;
  };

  Clock::time_point start_ = Clock::now();
  SlamConfig config_;
  std::unique_ptr<ScanSource> source_;
  RunFolder folder_;
  std::vector<ScanReader> readers_;  // one for each sensor
  MotionReader motion_reader_;
  OfflineExtent extent_;
  const SessionId first_session_;
  std::size_t total_;
  Progress progress_;
  VerdictNotice verdicts_;
  std::optional<LocalizedDrive> localized_;
  std::string tracked_frame_, said_time_source_;
  double reading_cpu_seconds_ = 0.0, finish_seconds_ = 0.0;
  std::vector<MemoryMark> memory_;

  std::string said_problem_;  // of the background

  std::mutex mutex_;  // guards the next two members
  std::vector<StageTimes> background_times_;
  int retroactive_pairs_ = 0;

  StagedExecutor executor_;
  Slam slam_;  // last: its stages speak to the observer
};

}  // namespace revisit_slam
