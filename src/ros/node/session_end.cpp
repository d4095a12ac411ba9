// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/session_end.h"

#include <ros/console.h>

#include <exception>
#include <iostream>

namespace revisit_slam {

std::string saveAll(GraphSession& session, DriveLog* log) {
  try {
    for (const std::string& notice : session.saveOwn()) ROS_WARN("%s", notice.c_str());
    RunSummary summary;
    if (log != nullptr) log->tell(summary);
    session.writeSummary(summary);
    if (log != nullptr) log->flush();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void endUnasked(GraphSession& session) {
  if (session.folder().empty()) return;
  // ROS no longer logs when a process is about to end.
  try {
    session.writeRest();
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
  }
  if (session.isWhole()) return;
  std::cerr << "the map was not made; this makes it: rosrun revisit_slam export "
            << session.folder() << std::endl;
}

}  // namespace revisit_slam
