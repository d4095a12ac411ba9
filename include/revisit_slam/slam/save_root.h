// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// Whether what somebody has asked to be saved in `folder` (empty: the folder of the session), or
/// loaded from it, may be there: below live/save_root, wherever `..` and links lead. Not in the
/// root itself: what is saved into a folder that is in use goes beside it.
/// @throws std::runtime_error naming both, if not.
void requireBelowSaveRoot(const LiveConfig& live, const std::string& folder);

}  // namespace revisit_slam
