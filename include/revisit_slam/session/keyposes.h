// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/session/session_reader.h"

namespace revisit_slam {

/// T_map_submap of the submaps of a session, by number, as text: a line for each, to the last bit.
std::string keyposeText(const std::vector<Pose>& T_map_submap);
/// @throws std::runtime_error naming a file that cannot be read, and what is wrong with it.
std::vector<Pose> readKeyposes(const std::string& path);

/// Moves the submaps of a single session to where these poses are. Scans between two keyposes take
/// their share of what the odometry between them is bent by (ChainPiece); those after the last
/// submap's first go with it. @throws std::runtime_error where there is not one pose for each
/// submap.
void moveToKeyposes(const std::vector<Pose>& T_map_submap, Session& session);

}  // namespace revisit_slam
