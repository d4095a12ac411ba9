// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// Where a program's parameters come from: each goes before those that stand before it.
struct ConfigSources {
  std::string preset, parameter_file;
  std::vector<std::string> settings;  ///< "group/name=value"
  /// As frames/base; "none": the sensor's own; empty: not given.
  std::string base_frame;
};

/// @param warnings gets one for each old name that is used  @throws ParameterError
SlamConfig readConfig(const ConfigSources& sources, std::vector<std::string>& warnings);

}  // namespace revisit_slam
