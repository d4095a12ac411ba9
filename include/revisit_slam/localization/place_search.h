// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/localization/prior_map.h"
#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

/// Recognises places of a map that another session made. Runs in the current TBB arena.
class PlaceSearch {
 public:
  PlaceSearch(PriorMapPtr map, const PlaceRecognitionConfig& config);

  /// T_map_local of where the local map may be, the best first; empty: nothing looks alike.
  std::vector<Pose> search(const LocalMap& local) const;

 private:
  PriorMapPtr map_;
  PlaceRecognitionConfig config_;
  PlaceRecognition recognition_;
};

}  // namespace revisit_slam
