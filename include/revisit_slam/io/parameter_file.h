// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "revisit_slam/util/parameters.h"

namespace YAML {
class Node;
}

namespace revisit_slam {

/// The values of a YAML file whose maps nest as the groups of parameters do.
/// @throws ParameterError when the file cannot be read or is not made of maps and scalars.
std::vector<NamedText> readParameterFile(const std::string& path);

/// The same of YAML text. @throws ParameterError likewise.
std::vector<NamedText> parseParameterText(const std::string& yaml);

/// The same of a part of a YAML document. @throws ParameterError likewise.
std::vector<NamedText> flattened(const YAML::Node& node);

/// The values in force, nested as the groups are.
nlohmann::json toJson(const std::vector<Parameter>& parameters);

}  // namespace revisit_slam
