// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/loops/recognition/place_recognition.h"
#include "revisit_slam/session/session_crossing.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// A session and its folder.
struct NamedSession {
  std::string name, folder;
};

/// Registers the submaps of the local maps that seem to show the same places, as a drive does that
/// is joined to a map (loops by appearance). Nothing is known of where one session lies in the
/// other: what it finds depends on these local maps alone, and not on what else is joined.
/// `matches` by the ids that the local maps have in their folders.
/// @throws std::runtime_error naming a folder that cannot be used.
SessionCrossing registerMatches(const NamedSession& source, const NamedSession& target,
                                const std::vector<PlaceMatch>& matches, const SlamConfig& config);

}  // namespace revisit_slam
