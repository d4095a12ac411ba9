// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/types/map_correction.h"

namespace revisit_slam {

/// What the graph says of all scans up to one of its newest session; without version and request.
MapCorrection correctionOf(const SlamGraph& graph, ScanId last);

}  // namespace revisit_slam
