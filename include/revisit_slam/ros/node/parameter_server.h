// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <vector>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The values below the namespace of `node`, nested as the groups are.
/// @throws ParameterError for a list.
std::vector<NamedText> readParameterServer(const ros::NodeHandle& node);

/// A struct of parameters as the server has it. @throws ParameterError (see assign)
template <typename Config>
Config loadConfig(const ros::NodeHandle& node) {
  Config config;
  assign(parametersOf(config), readParameterServer(node));
  return config;
}

}  // namespace revisit_slam
