// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

/// The nodes to hold fixed so that the others are determined: the first of every connected part of
/// the graph, in ascending order.
std::vector<ScanId> gaugeNodes(const PoseGraph& graph);

}  // namespace revisit_slam
