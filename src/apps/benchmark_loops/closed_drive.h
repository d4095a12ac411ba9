// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/evaluation/loop_labels.h"
#include "revisit_slam/evaluation/pose_interpolator.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/loops/search/loop_search_result.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/loop_edge.h"

namespace revisit_slam {

/// What loop closure made of one local map, and what that took of the machine. Milliseconds.
struct MapClosure {
  LoopSearchResult search;                // by appearance
  std::vector<LoopProposal> retroactive;  // that this map's closure set off
  double cpu_ms = 0.0;                    // of all threads, without optimisation
  double recognition_ms = 0.0, registration_ms = 0.0, retroactive_ms = 0.0;  // wall
  double optimisation_ms = 0.0;                                              // wall
};

struct ClosedDrive {
  std::vector<MapClosure> maps;          // by number
  std::vector<LoopProposal> at_the_end;  // retroactive, of the last search
  std::vector<LoopEdge> edges;           // as the back-end left them
  Trajectory odometry, trajectory;
};

/// The whole pipeline over all scans of a bag, with loops and graph map by map while nothing else
/// runs. An empty topic stands for the only one with scans. @throws BagError
ClosedDrive closeLoops(const std::string& bag, const std::string& topic, const SlamConfig& config,
                       bool quiet);

/// With the truth for the base frame, interpolated at the stamps of scans.
/// @throws std::runtime_error where the truth does not cover a scan.
Stretch stretchOf(const Submap& submap, const PoseInterpolator& truth);
Stretch stretchOf(const LocalMap& map, const PoseInterpolator& truth);

}  // namespace revisit_slam
