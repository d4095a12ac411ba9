// SPDX-License-Identifier: MIT
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/loops/search/loop_search_result.h"
#include "revisit_slam/pose_graph/slam_graph.h"

namespace revisit_slam {

/// All loop constraints of the graph with their ids, coloured by what became of them: green closed
/// by appearance, blue retroactively, orange down-weighted (to less than `min_inlier_weight`), red
/// rejected by the graph, grey disabled.
visualization_msgs::MarkerArray toLoopEdges(const SlamGraph& graph, double min_inlier_weight,
                                            const std::string& frame);

/// What searches for loops tried: grey the maps that looked alike, with the features that agreed;
/// green, red the pairs of submaps accepted and rejected, with the reason.
visualization_msgs::MarkerArray toLoopCandidates(const std::vector<LoopSearchResult>& searches,
                                                 const std::function<Pose(LocalMapId)>& T_map_local,
                                                 const std::function<Pose(SubmapId)>& T_map_submap,
                                                 const std::string& frame);

}  // namespace revisit_slam
