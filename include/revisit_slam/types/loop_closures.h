// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "revisit_slam/types/constraint.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/loop_candidate.h"

namespace revisit_slam {

struct PlaceView;

/// The loop constraints that a search for one local map has found, for the graph.
struct LoopClosures {
  LocalMapId map;    ///< the newest when the search was made
  ScanId last_scan;  ///< of that map: the graph is optimised up to here, whatever has come since
  LoopOrigin origin = LoopOrigin::appearance;
  /// Numbers the closures of a session from 1; the correction that answers them bears it.
  std::uint32_t request = 0;
  /// Without any there is nothing to correct, and no answer unless there is a request.
  std::vector<LoopConstraint> constraints;
  /// All pairs that were registered, for the session's files.
  std::vector<LoopCandidate> candidates;
  /// The map as place recognition sees it, for the session's files; null for retroactive ones.
  std::shared_ptr<const PlaceView> view;
};

}  // namespace revisit_slam
