// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "revisit_slam/util/stage_times.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/loops/search/loops_config.h"
#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

/// What the search for loops found out about a closed local map.
struct LoopSearchResult {
  LocalMapPtr map;
  std::shared_ptr<const PlaceView> view;  ///< the map as place recognition sees it
  std::vector<PlaceMatch> candidates;     ///< earlier maps that look alike, best first
  std::optional<PlaceMatch> match;        ///< the place recognised
  std::vector<LoopProposal> proposals;    ///< pairs of submaps registered, with their outcome
  StageTimes times;

  std::vector<LoopConstraint> accepted() const { return acceptedOf(proposals); }
};

/// Closes loops by appearance (paper Sec. III-C): recognises the place that a local map shows among
/// all earlier ones, and registers the submaps of both. Depends on the order of maps alone.
class LoopSearch {
 public:
  LoopSearch(const LoopsConfig& config, const InformationConfig& information);

  /// Takes effect with the next map. Acceptance may change while a drive goes on, pictures and
  /// registration may not.
  void reconfigure(const LoopsConfig& config) {
    config_ = config;
    recognition_.reconfigure(config.recognition);
    closer_.reconfigure(config.closer);
  }

  /// Ids count from 0 without gaps. Runs in the current TBB arena.
  LoopSearchResult search(const LocalMapPtr& map);

 private:
  LoopsConfig config_;
  PlaceRecognition recognition_;
  LoopCloser closer_;
  std::vector<LocalMapPtr> maps_;  // by LocalMapId
};

}  // namespace revisit_slam
