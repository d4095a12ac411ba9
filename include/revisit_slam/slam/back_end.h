// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/loops/search/retroactive_search.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// How much work the back-end has done.
struct BackEndCount {
  int optimisations = 0;
  int rejected_optimisations = 0;
  int retroactive_pairs = 0;  ///< pairs of submaps that were registered
  double optimisation_seconds = 0.0;
  double retroactive_seconds = 0.0;
};

/// The graph and what it does to the maps (paper Sec. III-D and III-E): optimises when a loop was
/// closed by appearance, searches the maps that this brought together for loops that appearance
/// missed, and optimises again. Where appearance closed none, the maps that the odometry alone places
/// near the newest are searched. What comes out depends on the order of calls alone: a local map is
/// always closed with the graph up to its last scan, whatever came since.
class BackEnd {
 public:
  /// `on_correction` gets every correction as soon as there is one; `on_proposals` (may be empty)
  /// every pair of submaps that the retroactive search registered.
  using OnCorrection = std::function<void(const MapCorrectionPtr&)>;
  using OnProposals = std::function<void(const std::vector<LoopProposal>&)>;
  BackEnd(const SlamConfig& config, OnCorrection on_correction, OnProposals on_proposals = {});

  /// Kernel, acceptance of loops and retroactive search, from the next local map on.
  void reconfigure(const SlamConfig& config);

  void add(const GraphNode& node) { graph_.add(node); }

  /// A local map and the loops that appearance closed for it. Its scans must have been added.
  /// Registration runs in the current TBB arena.
  void add(const LocalMapPtr& map, const std::vector<LoopConstraint>& loops);

  /// A last search over the maps since the last closure, and a last optimisation.
  void finish();

  /// Leaves a loop out and optimises without it. @return whether there was one to leave out.
  bool takeBack(LoopId id);

  /// One pose for each scan, those after the last optimisation carried along.
  Trajectory trajectory() const;
  const SlamGraph& graph() const { return graph_; }
  const std::vector<LocalMapPtr>& maps() const { return maps_; }
  const BackEndCount& count() const { return count_; }

 private:
  using Clock = std::chrono::steady_clock;

  ScanId lastScanOfMaps() const { return maps_.back()->submaps.back()->lastScan(); }
  void optimise(const std::vector<LoopConstraint>& new_loops);
  void searchRetroactively();
  void searchInReach();
  std::size_t close(const std::vector<RetroactiveCandidate>& candidates,
                    const std::vector<Pose>& T_map_scan, Clock::time_point start);
  std::vector<LoopProposal> close(const LocalMapPair& maps, const std::vector<Pose>& T_map_scan);

  SlamGraph graph_;
  LoopCloser closer_;
  RetroactiveSearch retroactive_;
  int max_pairs_;
  OnCorrection on_correction_;
  OnProposals on_proposals_;

  std::vector<LocalMapPtr> maps_;  // by LocalMapId
  std::set<LocalMapPair> closed_, tried_;
  std::optional<LocalMapId> searched_;  // p: up to it all maps were searched retroactively
  std::uint32_t version_ = 0;
  BackEndCount count_;
};

}  // namespace revisit_slam
