// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/pose_graph/pose_graph.h"

namespace revisit_slam {

/// The nodes to hold fixed so that the others are determined, in ascending order: those that the
/// graph holds, and the first of every other connected part which its absolute factors (those that
/// bind one node) leave free to move as a whole. They determine where a part lies if they say
/// something about every translation of it, and hold its rotation, whatever its translation, to 0.1
/// rad (one standard deviation) about every axis; judged at the poses of the graph, without
/// kernels. One position, or many along a straight line, do not: the first node then stays where it
/// is and the positions pull at the others.
std::vector<NodeId> gaugeNodes(const PoseGraph& graph);

}  // namespace revisit_slam
