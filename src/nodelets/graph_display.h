// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/backend/growing_graph.h"
#include "revisit_slam/core/submap.h"

namespace revisit_slam {

/// The graph for rviz. What nobody listens to is not built. Only one thread may use it.
class GraphDisplay {
 public:
  /// `on_subscriber` is called in a thread of the node when somebody begins to listen.
  GraphDisplay(ros::NodeHandle& node, const std::string& frame, double pulling_weight,
               std::function<void()> on_subscriber);

  void draw(const GrowingGraph& graph, const std::vector<SubmapPtr>& submaps) const;
  void drawPath(const GrowingGraph& graph) const;

 private:
  std::string frame_;
  double pulling_weight_;
  ros::Publisher path_, edges_, cloud_;
};

}  // namespace revisit_slam
