// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/session/graph_log.h"
#include "revisit_slam/session/session_graph.h"
#include "revisit_slam/session/session_info.h"

namespace revisit_slam {

/// The parameters that a session's files were made with, and that what is made from them follows.
struct StoredParameters {
  MappingConfig mapping;
  OccupancyConfig occupancy;
  BackEndConfig backend;
  GnssConfig gnss;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("mapping", mapping);
    v.group("occupancy", occupancy);
    v.group("backend", backend);
    v.group("gnss", gnss);
  }
};
StoredParameters storedParameters(const SessionInfo& info);

/// A session at one moment. The points of its submaps stay on disk.
struct Session {
  std::string folder;
  SessionInfo info;
  std::vector<SubmapClosed> submaps;  ///< by number
  SessionGraph graph;
};

/// Names of the files of a session.
std::string graphLogFile(const std::string& folder);
std::string optimisationsFile(const std::string& folder);
std::string submapFile(const std::string& folder, SubmapId id);
std::string localMapFile(const std::string& folder, LocalMapId id);

/// Reads a session, whether it was closed, is being written, or was killed. What cannot be used of
/// it is named in `notices`.
/// @throws std::runtime_error where session.yaml or the beginning of graph.log cannot be used.
Session readSession(const std::string& folder, std::vector<std::string>& notices);

}  // namespace revisit_slam
