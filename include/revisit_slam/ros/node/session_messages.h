// SPDX-License-Identifier: MIT
#pragma once

#include <boost/make_shared.hpp>
#include <cstdint>

#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/loops/search/loop_search.h"
#include "revisit_slam/slam/map_builder.h"
#include "revisit_slam/ros/node/in_process_topic.h"

namespace revisit_slam {

/// What passes between the nodelets for maps and graph. `session` is that of the scans
/// (RegisteredScan::session): what is still under way when the odometry starts anew belongs to the
/// drive before.

/// A submap that was closed, and the local map with the last of its submaps.
struct SessionMaps {
  std::int64_t session = 0;
  MapUpdate maps;
};

/// One for each closed local map, in order, with or without loops.
struct SessionLoops {
  std::int64_t session = 0;
  LoopSearchResult search;
};

struct SessionCorrection {
  std::int64_t session = 0;
  MapCorrectionPtr correction;
};

/// Asks for the open maps to be closed.
struct CloseMaps {
  std::uint32_t request = 0;
};

/// All maps of the session's first `scans` scans are closed, and searched for loops.
struct MapsClosed {
  std::int64_t session = 0;
  std::uint32_t scans = 0;
  std::uint32_t request = 0;  ///< what it answers; 0: a new session began
};

}  // namespace revisit_slam

REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::SessionMaps, "revisit_slam/SessionMaps",
                              "7265766973697473636e303030303033")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::SessionLoops, "revisit_slam/SessionLoops",
                              "7265766973697473636e303030303034")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::SessionCorrection, "revisit_slam/SessionCorrection",
                              "7265766973697473636e303030303035")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::CloseMaps, "revisit_slam/CloseMaps",
                              "7265766973697473636e303030303036")
REVISIT_SLAM_IN_PROCESS_TOPIC(revisit_slam::MapsClosed, "revisit_slam/MapsClosed",
                              "7265766973697473636e303030303037")
