// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/pose_graph/graph_node.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/evaluation/pose_interpolator.h"
#include "revisit_slam/evaluation/loop_labels.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// A drive as the odometry mapped it: what loop closure starts from.
struct MappedDrive {
  std::vector<GraphNode> nodes;   // by ScanId
  std::vector<LocalMapPtr> maps;  // by LocalMapId
};

/// Runs odometry, information and maps over all scans of a bag. An empty topic stands for the only
/// one with scans. @throws BagError
MappedDrive mapDrive(const std::string& bag, const std::string& topic, const SlamConfig& config,
                     bool quiet);

/// With the truth for the base frame, interpolated at the stamps of scans.
/// @throws std::runtime_error where the truth does not cover a scan.
Stretch stretchOf(const Submap& submap, const PoseInterpolator& truth);
Stretch stretchOf(const LocalMap& map, const PoseInterpolator& truth);

}  // namespace revisit_slam
