// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "mapped_drive.h"
#include "revisit_slam/types/loop_edge.h"
#include "revisit_slam/loops/acceptance/loop_closer.h"
#include "revisit_slam/loops/search/loop_search.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// What loop closure made of one local map, and what that took of the machine. Milliseconds.
struct MapClosure {
  LoopSearchResult search;
  std::vector<LoopProposal> retroactive;  // that this map's closure set off
  double cpu_ms = 0.0;                    // of all threads, without optimisation
  double recognition_ms = 0.0, registration_ms = 0.0, retroactive_ms = 0.0;  // wall
  double optimisation_ms = 0.0;                                              // wall
};

struct ClosedDrive {
  std::vector<MapClosure> maps;          // by LocalMapId
  std::vector<LoopProposal> at_the_end;  // retroactive, of the last search
  std::vector<LoopEdge> edges;           // as the back-end left them
  Trajectory trajectory;
};

/// Loop search and back-end as the pipeline runs them, map by map, in `config.background.threads`
/// threads and with nothing else running.
ClosedDrive closeLoops(const MappedDrive& drive, const SlamConfig& config);

}  // namespace revisit_slam
