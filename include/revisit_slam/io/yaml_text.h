// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace YAML {
class Node;
}

namespace revisit_slam {

/// The YAML document in `text`. What makes yaml-cpp 0.6 (Debian 11, Ubuntu 20.04) take memory
/// without end never reaches it: control characters, which YAML excludes, and ':' directly before
/// ']', within quotes too. Neither does more than 1 MiB: it takes many times what it reads.
/// @throws std::runtime_error with the line of what cannot be read.
YAML::Node parseYaml(const std::string& text);

/// parseYaml() of a file. @throws std::runtime_error naming the file.
YAML::Node readYaml(const std::string& path);

}  // namespace revisit_slam
