// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "revisit_slam/ros/node/map_loader.h"
#include "revisit_slam/session/known_map.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// The map that the first session goes on from, live/map; null: none. @throws ParameterError
KnownMapPtr mapToExtend(const SlamConfig& config);

/// The service that loads a map for the next session to go on from, and hands it to `take`, in a
/// thread of its own.
std::unique_ptr<MapLoader> loadMapsToExtend(const ros::NodeHandle& private_node,
                                            const SlamConfig& config,
                                            std::function<void(const KnownMapPtr&)> take);

}  // namespace revisit_slam
