// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "revisit_slam/loops/association/submap_association.h"
#include "revisit_slam/types/scan_poses.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

struct RetroactiveConfig {
  bool enabled = true;
  AssociationConfig association = withNeighboursLeftOut();
  double low_drift_window = 300.0;
  int novelty_range = 5;
  int max_pairs = 10;
  int max_partners = 10;
  bool search_at_end = true;
  bool within_maps = true;

  static AssociationConfig withNeighboursLeftOut() {
    AssociationConfig config;
    config.min_detour = 3.0;
    return config;
  }

  template <typename Visitor>
  void visit(Visitor& v) {
    v("enabled", enabled,
      "true: loops that appearance misses are searched for among trajectories that are near in "
      "the map; false: appearance alone closes loops (ablation)");
    v.group("association", association);
    v("low_drift_window", low_drift_window, Range{0.0, 100000.0}, "m",
      "travelled distance over which odometry alone is trusted: a local map without a loop by "
      "appearance is compared with earlier ones up to this far back; 0: none. Raise it if short "
      "loops stay open; lower it if odometry drifts by metres");
    v("novelty_range", novelty_range, Range{1, 1000}, "",
      "distance in local maps to the nearest closed pair from which on a candidate has full "
      "priority; nearer ones are searched later. Raise it if closures cluster in one area; lower "
      "it if candidates with near trajectories come too late");
    v("max_pairs", max_pairs, Range{1, 10000}, "",
      "number of pairs of submaps after which a search stops; the local maps that are left are "
      "searched after the next optimisation. Raise it if closing loops takes many optimisations; "
      "lower it if a search takes too long");
    v("max_partners", max_partners, Range{1, 1'000'000}, "",
      "number of other local maps that a local map has loops with from which on it is not "
      "compared with a further one that has as many, and three of them in common with it. Raise "
      "it if more of the passes through a place should be tied directly; lower it if laps of one "
      "place take too long");
    v("search_at_end", search_at_end,
      "true: the local maps since the last loop by appearance are searched when the drive is over; "
      "false: only a loop by appearance starts a search, as in the paper");
    v("within_maps", within_maps,
      "true: the submaps of one local map are compared with each other, too, which closes loops of "
      "small places; false: only those of different local maps, as in the paper");
  }
};

/// The later local map (source) and the earlier one (target); the same one twice for loops within
/// it.
using LocalMapPair = std::pair<LocalMapId, LocalMapId>;

struct RetroactiveCandidate {
  LocalMapPair maps;
  double hausdorff;  ///< m, of the optimised trajectories
  double gain;       ///< 0 … 1, expected: closeness times distance from other closures
};

/// The submaps of a local map as the graph placed them.
std::vector<PlacedSubmap> placeByGraph(const LocalMap& map, const ScanPoses& T_map_scan,
                                       const AssociationConfig& config);

/// Finds the pairs of local maps that optimisation brought together (paper Sec. III-E), and those
/// that the odometry alone places well.
class RetroactiveSearch {
 public:
  explicit RetroactiveSearch(const RetroactiveConfig& config) : config_(config) {}

  void reconfigure(const RetroactiveConfig& config) { config_ = config; }

  /// Pairs (i, j) with p < i <= n and j earlier, or i itself, not in `closed`, whose optimised
  /// trajectories satisfy d_H <= tau_H and come near where they are not neighbours along the drive;
  /// most promising first. `maps` of each session by number, session after session. Without `p`
  /// all maps up to n are searched.
  std::vector<RetroactiveCandidate> search(const std::vector<LocalMapPtr>& maps,
                                           const ScanPoses& T_map_scan, std::optional<LocalMapId> p,
                                           LocalMapId n,
                                           const std::set<LocalMapPair>& closed) const;

  /// Those of the map n alone within the low-drift window: no farther back, in travelled distance,
  /// than odometry alone is trusted to place maps.
  std::vector<RetroactiveCandidate> searchLowDriftWindow(
      const std::vector<LocalMapPtr>& maps, const ScanPoses& T_map_scan, LocalMapId n,
      const std::set<LocalMapPair>& closed) const;

 private:
  bool meetAgain(const LocalMap& later, const LocalMap& earlier, const ScanPoses& T_map_scan) const;
  void orderByGain(std::vector<RetroactiveCandidate>& candidates,
                   const std::set<LocalMapPair>& closed) const;

  RetroactiveConfig config_;
};

}  // namespace revisit_slam
