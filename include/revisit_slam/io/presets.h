// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// The names of the parameter files in cfg/, which are compiled in.
std::vector<std::string> presetNames();

/// The values of cfg/NAME.yaml. @throws ParameterError naming those that there are.
std::vector<NamedText> readPreset(const std::string& name);

}  // namespace revisit_slam
