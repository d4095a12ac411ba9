// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/Path.h>

#include <string>

#include "revisit_slam/pose_graph/slam_graph.h"

namespace revisit_slam {

/// The trajectory in the map. Poses are a metre apart, and farther where there would be more than
/// `max_poses`; the first and the last are always there.
nav_msgs::Path toPath(const SlamGraph& graph, std::size_t first, const std::string& frame,
                      std::size_t max_poses);

}  // namespace revisit_slam
