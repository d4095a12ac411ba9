// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>

#include "revisit_slam/localization/localization_state.h"
#include "revisit_slam/ros/node/prior_cloud.h"
#include "revisit_slam/slam/graph_session.h"

namespace revisit_slam {

/// The map that a drive goes on from, in grey, and whether the drive has been found in it. What
/// nobody listens to is not built. Only one thread may use it.
class ExtensionDisplay {
 public:
  /// `on_subscriber` is called in a thread of the node when somebody begins to listen.
  ExtensionDisplay(ros::NodeHandle& node, const SlamConfig& config,
                   const std::function<void()>& on_subscriber);

  void draw(const GraphSession& session);

 private:
  void drawMap(const GraphSession& session);

  std::string frame_;
  int max_points_;
  ros::Publisher map_, status_, text_;
  KnownMapPtr drawn_;  // what cloud_ is of
  PriorCloud cloud_;
  std::optional<LocalizationState> told_;
  SessionId told_of_;
};

}  // namespace revisit_slam
