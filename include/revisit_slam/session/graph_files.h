// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/pose_graph/slam_graph.h"

namespace revisit_slam {

/// One pose for each scan, those after the last optimisation carried along.
Trajectory trajectoryOf(const SlamGraph& graph);

/// pose_graph.g2o: all scans and the constraints that are active; rotation and translation in g2o's
/// order and scale. @throws std::runtime_error naming the file.
void writeGraph(const std::string& path, const SlamGraph& graph);

/// loop_closures.csv: every loop constraint with its origin, state, relative pose, fitness and
/// residuals before and after. @throws std::runtime_error naming the file.
void writeLoops(const std::string& path, const SlamGraph& graph);

}  // namespace revisit_slam
