// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "revisit_slam/slam/back_end.h"
#include "revisit_slam/slam/executor.h"
#include "revisit_slam/slam/information_stage.h"
#include "revisit_slam/slam/map_manager.h"
#include "revisit_slam/slam/odometry_stage.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/slam/slam_observer.h"

namespace revisit_slam {

/// The four stages of a drive, connected: odometry -> information -> maps and loops <-> graph. The
/// one place that orders them. The same scans give the same results, to the last bit, with any
/// executor and however its threads take turns.
class Slam {
 public:
  /// Observer and executor must outlive this.
  /// `targets`: where sessions are written; null: as live/folder says. `prior`: what the drive goes
  /// on from; null: nothing.
  Slam(const SlamConfig& config, SlamObserver& observer, Executor& executor,
       SessionTargets targets = {}, const KnownMapPtr& prior = {});
  ~Slam();

  /// `times`: what the reading took, for the observer.
  void insert(ScanReading reading, const StageTimes& times = {});
  /// Motion that was measured outside (OdometryStage).
  void insert(const MotionReading& reading);
  /// A scan that has its information already.
  void insert(const InformedScan& informed);
  /// Counts a message that never became a reading.
  void countDropped(const std::string& reason) { odometry_.countDropped(reason); }
  void countDroppedMotion(const std::string& sensor, const std::string& reason) {
    odometry_.countDroppedMotion(sensor, reason);
  }

  /// Closes the open maps, searches and optimises a last time, and waits for the end of it.
  /// @throws what the background has thrown.
  void finish();

  const ScanAccount& account() const { return odometry_.account(); }
  std::map<std::string, PriorAccount> sensorAccounts() const { return odometry_.sensorAccounts(); }
  std::map<std::string, SensorAccount> lidarAccounts() const { return odometry_.lidarAccounts(); }
  /// After finish(): the last; null without scans.
  GraphSession* session() { return back_end_.session(); }
  const GraphSession* session() const { return back_end_.session(); }

 private:
  void take(const OdometryStage::Result& result, StageTimes times);
  void end(const MapsClosed& closed);
  MapManager::Outputs outputsOfMaps();

  SlamObserver& observer_;
  Executor& executor_;
  const bool with_maps_;
  bool has_scans_ = false;
  OdometryStage odometry_;
  InformationStage information_;
  BackEnd back_end_;
  InlineLane foreground_;
  MapManager maps_;
};

}  // namespace revisit_slam
