// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/types/session_offsets.h"

namespace revisit_slam {

/// What the graph of a session says at one moment: a value.
struct SessionGraph {
  std::vector<GraphNode> nodes;  ///< session after session, by scan number
  std::vector<Pose> T_map_scan;  ///< likewise
  Pose T_map_odom;               ///< of the last session
  std::vector<LoopEdge> loops;   ///< by LoopId
  std::optional<Georeference> georeference;
};

/// Where each scan is among the nodes.
SessionOffsets<ScanId> scansOf(const SessionGraph& graph);

SessionGraph graphOf(const SlamGraph& graph);

/// One pose for each scan.
Trajectory trajectoryOf(const SessionGraph& graph);

/// pose_graph.g2o: all scans and the constraints that are active; rotation and translation in g2o's
/// order and scale. @throws std::runtime_error naming the file.
void writeGraph(const std::string& path, const SessionGraph& graph);

/// loop_closures.csv: every loop constraint with its origin, state, relative pose, fitness and
/// residuals before and after. @throws std::runtime_error naming the file.
void writeLoops(const std::string& path, const SessionGraph& graph);

}  // namespace revisit_slam
