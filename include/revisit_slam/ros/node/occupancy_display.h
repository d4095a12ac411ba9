// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "revisit_slam/occupancy/occupancy_map.h"
#include "revisit_slam/slam/graph_session.h"

namespace revisit_slam {

/// The occupancy of the corrected map, for rviz and navigation. It follows the graph: only what
/// moved is composed again, and nothing while nobody listens. Only one thread may use it.
class OccupancyDisplay {
 public:
  /// `on_subscriber` is called in a thread of the node when somebody begins to listen.
  OccupancyDisplay(ros::NodeHandle& node, const std::string& frame, const OccupancyConfig& config,
                   const std::function<void()>& on_subscriber);

  void draw(const GraphSession& session);
  /// Another drive begins.
  void clear() { map_ = OccupancyMap(config_); }

 private:
  void place(const GraphSession& session);

  std::string frame_;
  OccupancyConfig config_;
  OccupancyMap map_;
  ros::Publisher cells_, voxels_, grid_;
  ros::Publisher octomap_;  // of nothing without octomap_msgs
};

}  // namespace revisit_slam
