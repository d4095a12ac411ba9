// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_arena.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/mapping/map_scale.h"
#include "revisit_slam/slam/loop_closing.h"
#include "revisit_slam/slam/session_order.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/util/lane.h"

namespace revisit_slam {

/// How much the map manager has done. Of its two lanes.
struct MapManagerCount {
  std::atomic<int> missed_scans{0};   ///< of no use, as scans before them were missed
  std::atomic<int> maps_waiting{0};   ///< local maps that have not been searched wholly
  std::atomic<int> thinned_scans{0};  ///< in the trajectories of submaps, but without their points
};

/// Builds submaps and local maps from the scans of session after session in one lane, and closes
/// loops between the local maps in another, so that building does not wait for it.
class MapManager {
 public:
  struct Outputs {
    std::function<void(const MapUpdatePtr&)> maps;  ///< in the lane that builds
    /// Another session begins, going on from `prior`, null: from nothing; in the lane that
    /// searches.
    std::function<void(SessionId, const KnownMapPtr& prior)> session;
    LoopClosing::Outputs loops;  ///< in the lane that searches
  };

  /// The lanes must outlive this, or end before it does.
  MapManager(const SlamConfig& config, Lane& building, Lane& searching, Outputs outputs);

  // In any thread, always the same order.

  /// The first scan of another session closes the maps of the one before. Scans whose predecessors
  /// were missed are of no use. Where more than mapping/max_waiting scans wait, this one gets by
  /// without its points: that bounds the memory, and no scan is missing in a trajectory.
  void insert(const InformedScan& informed);

  /// Closes the open maps. When they are searched `loops.closed` follows.
  void close(std::uint32_t request);

  // In any thread.

  void correct(const MapCorrectionPtr& correction);
  void reconfigure(const std::function<void(LoopsConfig&, RetroactiveConfig&)>& change);

  /// There is no graph that could answer: goes on without.
  void giveUpWaiting();

  const MapManagerCount& count() const { return count_; }

 private:
  /// What a scan adds to the unsure distance of the odometry.
  struct Unsure {
    double weak = 0.0, weak_height = 0.0;  // shares of the way since the scan before
    double doubt = 0.0;                    // m
  };

  static Unsure unsureOf(const InformedScan& informed);
  void build(const RegisteredScan& scan, const Unsure& unsure);
  SubmapStart startWith(const RegisteredScan& scan, const Unsure& unsure);
  void hand(MapUpdate update);
  void closeSession(std::uint32_t request, std::uint32_t scans);
  void begin(SessionId session, const KnownMapPtr& prior,
             const std::shared_ptr<SubmapLibrary>& library);
  void inLane(SessionId session, const std::function<void(LoopClosing&)>& work);
  void tidyUp();

  const MappingConfig mapping_;
  const OccupancyConfig occupancy_;
  const MapScale scale_;
  Lane &building_, &searching_;
  const Outputs outputs_;
  MapManagerCount count_;
  std::atomic<int> handed_{0};  // local maps on their way from lane to lane

  // In the lane that builds.
  SessionOrder order_;
  SessionId session_;
  std::unique_ptr<MapBuilder> builder_;     // null before the first scan
  std::shared_ptr<SubmapLibrary> library_;  // of the session
  UnsureDistance unsure_;
  Eigen::Vector3d position_odom_ = Eigen::Vector3d::Zero();  // of the scan before

  // In the lane that searches.
  tbb::task_arena arena_;
  SlamConfig config_;  // in force
  SessionId newest_;
  std::map<SessionId, LoopClosing> closing_;  // of the newest session, and those with work left
};

}  // namespace revisit_slam
