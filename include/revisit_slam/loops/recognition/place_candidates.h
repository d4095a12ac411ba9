// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "revisit_slam/loops/recognition/place_index.h"
#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

struct PlaceCandidatesConfig {
  PlaceIndexConfig index;
  /// Places that the index names for each place, and that are compared with it; 0: all are
  /// compared.
  int shortlist = 64;
  /// Sessions that each place is matched with, those that agree best.
  int partners = 5;
  /// Places, from the first on, that partners are looked for; 0: all.
  std::size_t queries = 0;
};

/// Of all places of several sessions those pairs that seem to show the same, of different sessions:
/// for each place the best place of each of its best partners, with the later session as source. By
/// source, then by target. `places` session after session; views without picture. Runs in the
/// current TBB arena; the same for any number of threads.
std::vector<PlaceMatch> findPlaceCandidates(const std::vector<PlaceView>& places,
                                            const PlaceRecognitionConfig& recognition,
                                            const PlaceCandidatesConfig& config,
                                            const std::function<void(std::size_t)>& on_places = {});

}  // namespace revisit_slam
