// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

#include "revisit_slam/ros/node/extension_display.h"

namespace revisit_slam {

/// The graph for rviz, where it is known where the session lies in the map. What nobody listens to
/// is not built. Only one thread may use it.
class GraphDisplay {
 public:
  /// `on_subscriber` is called in a thread of the node when somebody begins to listen.
  GraphDisplay(ros::NodeHandle& node, const SlamConfig& config,
               std::function<void()> on_subscriber);

  void draw(const GraphSession& session);
  void drawPath(const GraphSession& session) const;

 private:
  std::string frame_;
  double min_inlier_weight_;
  int max_points_;
  ros::Publisher path_, edges_, cloud_;
  ExtensionDisplay extension_;
};

}  // namespace revisit_slam
