// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "revisit_slam/types/constraint.h"

namespace revisit_slam {

/// What registering two sessions has found of where they show the same.
struct SessionCrossing {
  std::string source, target;  ///< names of the sessions
  /// That passed the gates; ids as in the folders of the sessions.
  std::vector<LoopConstraint> loops;
  std::map<std::string, std::size_t> outcomes;  ///< pairs of submaps by the gate that rejected them
};

/// As bytes of a file.
std::string encodeCrossing(const SessionCrossing& crossing);
/// @throws std::runtime_error naming a file that cannot be read, or is damaged.
SessionCrossing readCrossing(const std::string& path);

}  // namespace revisit_slam
