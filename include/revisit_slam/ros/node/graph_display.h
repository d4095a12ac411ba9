// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// The graph for rviz. What nobody listens to is not built. Only one thread may use it.
class GraphDisplay {
 public:
  /// `on_subscriber` is called in a thread of the node when somebody begins to listen.
  GraphDisplay(ros::NodeHandle& node, const std::string& frame, double min_inlier_weight,
               std::function<void()> on_subscriber);

  void draw(const SlamGraph& graph, const std::vector<SubmapPtr>& submaps) const;
  void drawPath(const SlamGraph& graph) const;

 private:
  std::string frame_;
  double min_inlier_weight_;
  ros::Publisher path_, edges_, cloud_;
};

}  // namespace revisit_slam
