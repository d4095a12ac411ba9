// SPDX-License-Identifier: MIT
#pragma once

#include <ros/console.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "revisit_slam/slam/renamed_parameters.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The values below the namespace of `node`, nested as the groups are, with those of the preset
/// that the parameter `preset` names before them. @throws ParameterError for a list, or another
/// preset.
std::vector<NamedText> readParameterServer(const ros::NodeHandle& node);

/// A struct of parameters as the server has it; warns of old names. @throws ParameterError (see
/// assign)
template <typename Config>
Config loadConfig(const ros::NodeHandle& node) {
  Config config;
  for (const std::string& warning :
       assign(parametersOf(config), readParameterServer(node), kRenamedParameters))
    ROS_WARN("%s", warning.c_str());
  return config;
}

}  // namespace revisit_slam
