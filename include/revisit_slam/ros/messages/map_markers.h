// SPDX-License-Identifier: MIT
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// A box around the points of every local map, in its colour, with its number. `T_map_local` counts
/// by LocalMapId.
visualization_msgs::MarkerArray toOutlines(const std::vector<LocalMapPtr>& maps,
                                           const std::vector<Pose>& T_map_local,
                                           const std::string& frame);

/// The keypose of every submap, in the colour of its local map. `T_map_submap` counts by SubmapId.
visualization_msgs::MarkerArray toKeyposes(const std::vector<SubmapPtr>& submaps,
                                           const std::vector<Pose>& T_map_submap,
                                           const std::string& frame);

}  // namespace revisit_slam
