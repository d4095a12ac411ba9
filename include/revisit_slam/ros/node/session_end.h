// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/session/drive_log.h"
#include "revisit_slam/slam/graph_session.h"

namespace revisit_slam {

/// Makes all files of the session and run.json; what cannot be made of it is said in the log.
/// `log`: of its scans; null where there is no folder.
/// @return what cannot be written; else empty.
std::string saveAll(GraphSession& session, DriveLog* log);

/// For the end of a process that nobody has finished: the time until it is killed may be short. The
/// map is made later, by a command that is printed.
void endUnasked(GraphSession& session);

}  // namespace revisit_slam
