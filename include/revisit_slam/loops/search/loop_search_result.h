// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/loops/recognition/place_recognition.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

/// What a search for loops has found.
struct LoopSearchResult {
  LoopOrigin origin = LoopOrigin::appearance;
  LocalMapPtr map;                      ///< the newest; by appearance: with its points
  std::vector<LoopProposal> proposals;  ///< pairs of submaps registered, with their outcome
  StageTimes times;

  // By appearance alone:
  std::shared_ptr<const PlaceView> view;  ///< the map as place recognition sees it
  std::vector<PlaceMatch> candidates;     ///< earlier maps that look alike, best first
  std::optional<PlaceMatch> match;        ///< the place recognised

  std::vector<LoopConstraint> accepted() const { return acceptedOf(proposals); }
};

}  // namespace revisit_slam
