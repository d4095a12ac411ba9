// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/map_to_extend_loader.h"

#include <ros/console.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "revisit_slam/slam/map_to_extend.h"

namespace revisit_slam {
namespace {

KnownMapPtr read(const std::string& folder, const SlamConfig& config) {
  if (!config.mapping.enabled)
    throw std::runtime_error("mapping/enabled is false: nothing can go on from a map");
  std::vector<std::string> notices;
  KnownMapPtr map = readMapToExtend(folder, config.loops.recognition, notices);
  for (const std::string& notice : notices) ROS_WARN("%s", notice.c_str());
  return map;
}

}  // namespace

KnownMapPtr mapToExtend(const SlamConfig& config) {
  if (config.live.map.empty() && config.live.mode == "extend")
    throw ParameterError(
        "live/mode is extend, but live/map is empty: which session is to be "
        "extended? Set map:=FOLDER, or mode:=map for a new map");
  if (!config.live.map.empty() && config.live.mode != "extend")
    throw ParameterError("live/map is '" + config.live.map + "', but live/mode is " +
                         config.live.mode +
                         ": set mode:=extend to go on from that map, mode:=localize to find the "
                         "drive in it, or leave map out");
  if (config.live.map.empty()) return nullptr;
  try {
    return read(config.live.map, config);
  } catch (const std::runtime_error& error) {
    throw ParameterError("live/map = '" + config.live.map + "': " + error.what());
  }
}

std::unique_ptr<MapLoader> loadMapsToExtend(const ros::NodeHandle& private_node,
                                            const SlamConfig& config,
                                            std::function<void(const KnownMapPtr&)> take) {
  return std::make_unique<MapLoader>(
      private_node, config.live,
      [config, take = std::move(take)](const std::string& folder, LoadMap::Response& response) {
        const KnownMapPtr map = read(folder, config);
        for (const LocalMapPtr& local_map : map->maps)
          response.submaps += static_cast<std::uint32_t>(local_map->submaps.size());
        response.places = static_cast<std::uint32_t>(
            std::count_if(map->places.begin(), map->places.end(),
                          [](const PlaceView& place) { return place.features.size() > 0; }));
        take(map);
        response.message = "a new session goes on from it with the next scan";
      });
}

}  // namespace revisit_slam
