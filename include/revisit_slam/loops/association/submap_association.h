// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/loops/association/hausdorff.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

struct AssociationConfig {
  double max_hausdorff = 100.0;
  double max_gap = 40.0;
  double min_detour = 0.0;
  double min_overlap = 0.2;
  std::string target = "overlap";
  std::string trajectories = "odometry";

  bool usesOptimisedTrajectories() const { return trajectories == "optimised"; }

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_hausdorff", max_hausdorff, Range{0.0, 10000.0}, "m",
      "tau_H, largest Hausdorff distance in metres of two trajectories that are compared. Raise it "
      "if revisits are missed because drift puts their trajectories far apart; lower it if too "
      "many pairs are registered in vain");
    v("max_gap", max_gap, Range{0.0, 10000.0}, "m",
      "largest distance in metres between two trajectories where they are closest. Raise it if the "
      "sensor sees far and parallel streets should be matched; lower it if pairs are registered "
      "that share too little of their surroundings");
    v("min_detour", min_detour, Range{0.0, 1000.0}, "",
      "smallest ratio of the travelled distance between the middles of two submaps to the distance "
      "between their trajectories plus the size of a submap, at which they are compared; 0: no "
      "limit. Raise it if submaps are matched with their neighbours along the drive; lower it if "
      "short loops are missed");
    v("min_overlap", min_overlap, Range{0.0, 1.0}, "",
      "smallest share of their surroundings, in coarse cubes, that two submaps have to share where "
      "they are placed to be registered. Raise it if too many pairs are registered in vain; lower "
      "it if revisits are missed because drift puts their surroundings far apart");
    v("target", target, Choices{"overlap", "nearest"}, "",
      "which submap of the other local map a submap is registered to. overlap: the one that sees "
      "most of the same; nearest: the one of the smallest Hausdorff distance, as in the paper");
    v("trajectories", trajectories, Choices{"odometry", "optimised"}, "",
      "shape of the trajectories that are compared. odometry: as they were when their submap was "
      "closed; optimised: recomputed after each optimisation, as in the paper");
  }
};

/// A submap and where it is, in a frame that all submaps compared share: that of the target local
/// map (appearance), or the map (retroactive).
struct PlacedSubmap {
  SubmapPtr submap;
  Pose T_common_submap;
  /// Of each scan, as the graph has them; empty: from T_common_submap on as the odometry had them.
  std::vector<Pose> T_common_scan = {};
};

/// Travelled distance from the end of the earlier one to the beginning of the later one, m;
/// infinite between sessions.
double travelledBetween(const Submap& later, const Submap& earlier);

/// How near the trajectories of two submaps have to come to be compared, m; negative: they are
/// neighbours along the drive, and not compared at all. Neighbours are told by travelled distance
/// over displacement, which is the same for streets and for rooms.
double largestGap(const Submap& later, const Submap& earlier, const AssociationConfig& config);

/// The submaps of a local map as the odometry placed them, with the local map at `T_common_local`.
std::vector<PlacedSubmap> placeByOdometry(const LocalMap& map, const Pose& T_common_local);

/// The same submaps in another common frame.
std::vector<PlacedSubmap> moved(std::vector<PlacedSubmap> submaps, const Pose& T_new_common);

/// That of the submap with the widest surroundings; 1 without any.
double scaleOf(const std::vector<PlacedSubmap>& a, const std::vector<PlacedSubmap>& b);

/// The trajectory of a submap in the common frame.
Path pathOf(const PlacedSubmap& placed);

/// Indices into the lists of sources (k) and targets (r).
struct SubmapPair {
  std::size_t source;
  std::size_t target;
  double hausdorff;  ///< m
  double overlap;    ///< of what both see, as placed: 0 … 1
};

/// Z_ij: for each source submap one target submap whose Hausdorff distance is at most tau_H (paper
/// Sec. III-C). The paper takes the nearest (`target` nearest); by default it is the one that sees
/// most of the same, and of those that see equally much the nearest: a sensor that looks ahead sees
/// on its way back what it saw from another stretch of the way out.
std::vector<SubmapPair> associate(const std::vector<PlacedSubmap>& sources,
                                  const std::vector<PlacedSubmap>& targets,
                                  const AssociationConfig& config);

}  // namespace revisit_slam
