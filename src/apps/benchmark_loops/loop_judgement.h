// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "closed_drive.h"
#include "revisit_slam/evaluation/loop_labels.h"

namespace revisit_slam {

/// What counts as right, where the maps or submaps are closest. A local-map closure is what place
/// recognition says before any registration.
struct LoopLimits {
  double map_translation = 3.0;         ///< m
  double map_rotation = 5.0;            ///< degrees
  double constraint_translation = 0.3;  ///< m
  double constraint_rotation = 0.5;     ///< degrees
};

/// A guess at a local-map closure, with its label.
struct JudgedMatch {
  PlaceMatch match;
  LoopLabel label;
  LoopError error;
  bool is_right = false;
};

/// An earlier local map that the query may be matched with.
struct LabelledPair {
  LocalMapId target;
  LoopLabel label;
};

struct JudgedMap {
  LocalMapId id;
  double length = 0.0;  ///< m
  std::vector<LabelledPair> earlier;
  std::optional<LabelledPair> revisit;  ///< the pair that shares most, if it is one
  std::optional<JudgedMatch> match;
  bool is_confirmed = false;            ///< registration accepted a constraint of the match
  std::vector<JudgedMatch> candidates;  ///< however few their inliers
};

struct JudgedConstraint {
  LoopProposal proposal;
  LoopLabel label;  ///< of the submaps
  LoopError at_keypose, at_place;
  bool is_right = false, is_right_at_keypose = false;
  std::string state;  ///< in the graph in the end, where it was accepted
};

struct Judgement {
  std::vector<JudgedMap> maps;
  std::vector<JudgedConstraint> constraints;
};

Judgement judge(const ClosedDrive& closed, const PoseInterpolator& truth,
                std::size_t newest_excluded, const LoopLimits& limits);

}  // namespace revisit_slam
