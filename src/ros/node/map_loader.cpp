// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/map_loader.h"

#include <ros/console.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "revisit_slam/slam/save_root.h"

namespace revisit_slam {
namespace {

std::string inFolder(const std::string& map, const std::string& folder) {
  if (map.empty()) throw std::runtime_error("no map: give the folder of a session");
  if (std::filesystem::path(map).is_absolute()) return map;
  if (folder.empty())
    throw std::runtime_error("'" + map +
                             "' is relative: give an absolute folder, or set live/folder, in which "
                             "relative ones are");
  return folder + "/" + map;
}

}  // namespace

MapLoader::MapLoader(const ros::NodeHandle& private_node, const LiveConfig& live, Load load)
    : live_(live), load_(std::move(load)) {
  ros::NodeHandle node(private_node);
  node.setCallbackQueue(&queue_);
  service_ = node.advertiseService("load", &MapLoader::load, this);
  spinner_.start();
}

void MapLoader::stop() {
  spinner_.stop();
}

bool MapLoader::load(LoadMap::Request& request, LoadMap::Response& response) {
  try {
    const std::string folder = inFolder(request.map, live_.folder);
    requireBelowSaveRoot(live_, request.map);
    load_(folder, response);
    response.success = true;
    response.message =
        "loaded '" + folder + "'" + (response.message.empty() ? "" : "; " + response.message);
    ROS_INFO("%s", response.message.c_str());
  } catch (const std::exception& error) {
    response.message = std::string("not loaded, and nothing has changed: ") + error.what();
    ROS_ERROR("%s", response.message.c_str());
  }
  return true;
}

}  // namespace revisit_slam
