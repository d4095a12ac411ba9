// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <string>
#include <variant>

#include "revisit_slam/session/graph_log.h"
#include "revisit_slam/session/session_reader.h"

namespace revisit_slam {

/// As if the process had been killed: whoever reads the session optimises the graph once more.
inline void forgetTrajectory(const std::string& session) {
  const GraphLog log = readGraphLog(optimisationsFile(session));
  std::string without = graphLogHeader();
  for (const LogEntry& entry : log.entries)
    if (!std::holds_alternative<TrajectoryWritten>(entry)) without += encodeEntry(entry);
  std::ofstream(optimisationsFile(session), std::ios::binary) << without;
}

}  // namespace revisit_slam
