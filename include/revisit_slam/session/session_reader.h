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
  GravityConfig gravity;

  template <typename Visitor>
  void visit(Visitor& v) {
    v.group("mapping", mapping);
    v.group("occupancy", occupancy);
    v.group("backend", backend);
    v.group("gnss", gnss);
    v.group("gravity", gravity);
  }
};
StoredParameters storedParameters(const SessionInfo& info);

/// What a folder holds at one moment: a session, or several that were joined. The points of the
/// submaps stay on disk.
struct Session {
  std::string folder;
  SessionInfo info;
  std::vector<SubmapClosed> submaps;  ///< session after session, by number
  SessionGraph graph;
};

/// The sessions in a folder, in order.
std::vector<SessionId> sessionsOf(const Session& session);
/// Without the sessions that no loop ties to this one: where these lie in its map nobody knows.
Session tiedTo(SessionId session, Session all);

/// Names of the files of a session. In the folder of another session, which is the `owner`, the
/// names of submaps and local maps tell the session.
std::string graphLogFile(const std::string& folder);
std::string optimisationsFile(const std::string& folder);
std::string submapFile(const std::string& folder, SubmapId id, SessionId owner);
std::string localMapFile(const std::string& folder, LocalMapId id, SessionId owner);
inline std::string submapFile(const std::string& folder, SubmapId id) {
  return submapFile(folder, id, id.session);
}
inline std::string localMapFile(const std::string& folder, LocalMapId id) {
  return localMapFile(folder, id, id.session);
}

/// Reads a session, whether it was closed, is being written, or was killed. What cannot be used of
/// it is named in `notices`.
/// @throws std::runtime_error where session.yaml or the beginning of graph.log cannot be used.
Session readSession(const std::string& folder, std::vector<std::string>& notices);

}  // namespace revisit_slam
