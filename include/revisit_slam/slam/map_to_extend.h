// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/session/known_map.h"

namespace revisit_slam {

/// The map in a folder, for a drive that goes on from it. What cannot be used of it is named in
/// `notices`.
/// @throws std::runtime_error naming the folder and the reason where no drive could: it is being
/// written, is no session, has no closed submap, or no place that could be recognised.
KnownMapPtr readMapToExtend(const std::string& folder, const PlaceRecognitionConfig& recognition,
                            std::vector<std::string>& notices);

}  // namespace revisit_slam
