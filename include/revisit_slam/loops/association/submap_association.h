// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/util/parameters.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/loops/association/hausdorff.h"

namespace revisit_slam {

struct AssociationConfig {
  double max_hausdorff = 100.0;
  double max_gap = 40.0;
  double min_way = 0.0;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("max_hausdorff", max_hausdorff, Range{0.0, 10000.0}, "m",
      "tau_H, largest Hausdorff distance of trajectories that are compared");
    v("max_gap", max_gap, Range{0.0, 10000.0}, "m",
      "trajectories that stay farther apart see too little of the same to be compared");
    v("min_way", min_way, Range{0.0, 100000.0}, "m",
      "submaps with less of the way between them are neighbours, not revisits");
  }
};

/// A submap and where it is, in a frame that all submaps compared share: that of the target local
/// map (appearance), or the map (retroactive).
struct PlacedSubmap {
  SubmapPtr submap;
  Pose T_common_submap;
};

/// m, between the end of the earlier one and the beginning of the later one.
double wayBetween(const Submap& later, const Submap& earlier);

/// The submaps of a local map as the odometry placed them, with the local map at `T_common_local`.
std::vector<PlacedSubmap> placeByOdometry(const LocalMap& map, const Pose& T_common_local);

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
/// Sec. III-C). The paper takes the nearest; we take the one that sees most of the same, and of
/// those that see equally much the nearest: a sensor that looks ahead sees on its way back what it
/// saw from another stretch of the way out.
std::vector<SubmapPair> associate(const std::vector<PlacedSubmap>& sources,
                                  const std::vector<PlacedSubmap>& targets,
                                  const AssociationConfig& config);

}  // namespace revisit_slam
