// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "revisit_slam/session/session_writer.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// Where a session that begins is to be written.
using SessionTargets = std::function<SessionTarget(SessionId, Stamp start)>;

/// A new folder for each session in live/folder, named by its first scan; nowhere without one.
SessionTargets liveTargets(const LiveConfig& live, const std::string& sensor = "");

/// Makes live/folder, if it is set, and tries it out, so that nobody drives in vain.
/// @throws ParameterError naming the folder and why nothing can be written there.
void requireWritable(const LiveConfig& live);

/// The folder that a session is saved in on request: `folder`, with a number behind it if it is in
/// use already; a relative one is within live/folder. @throws std::runtime_error where it is not.
std::string folderToSaveIn(const std::string& folder, const LiveConfig& live);

}  // namespace revisit_slam
