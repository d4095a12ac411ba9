// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/types/map_correction.h"

namespace revisit_slam {

/// What the graph says of all scans up to one of its newest session; without version and request.
MapCorrection correctionOf(const SlamGraph& graph, ScanId last);
/// Where sessions lie that were mapped before, as they were left; likewise, and without T_map_odom.
MapCorrection correctionOf(const std::vector<const KnownMap*>& maps);

}  // namespace revisit_slam
