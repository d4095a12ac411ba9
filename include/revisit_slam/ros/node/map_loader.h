// SPDX-License-Identifier: MIT
#pragma once

#include <revisit_slam/LoadMap.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <functional>
#include <string>

#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// The service `load`, in a thread of its own: a map is read while everything else goes on.
class MapLoader {
 public:
  /// Reads the map in a folder and hands it on. Fills in what it holds.
  /// @throws std::exception with the reason where it cannot be used; nothing is handed on then.
  using Load = std::function<void(const std::string& folder, LoadMap::Response& response)>;

  /// Relative folders are in live/folder; where that is empty they are refused.
  MapLoader(const ros::NodeHandle& private_node, const LiveConfig& live, Load load);
  /// Returns when no call waits any more.
  void stop();

 private:
  bool load(LoadMap::Request& request, LoadMap::Response& response);

  const LiveConfig live_;
  const Load load_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  ros::ServiceServer service_;
};

}  // namespace revisit_slam
