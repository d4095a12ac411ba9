// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/types/geodetic_position.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/stamp.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// A session that is in the folder of another one.
struct JoinedSession {
  SessionId id;
  Stamp start;         ///< of the first scan
  std::string sensor;  ///< where the scans came from
  std::string from;    ///< folder that it was taken from
};

/// What session.yaml says of a session.
struct SessionInfo {
  bool closed = false;   ///< every scan is in a submap that is in the folder
  std::string software;  ///< version that wrote it
  SessionId id;
  Stamp start;  ///< of the first scan
  std::string map_frame, odom_frame, base_frame;
  std::string sensor;                 ///< where the scans came from: topic, bag, frame
  std::vector<NamedText> parameters;  ///< in force at the start
  std::vector<JoinedSession> joined;  ///< by id, which are above its own
  /// Of the frame enu, as soon as the map is aligned with it.
  std::optional<GeodeticPosition> datum;
};

/// The version of this software.
std::string softwareVersion();

std::vector<NamedText> textOf(const std::vector<Parameter>& parameters);

/// Sets those of `parameters` that are among the values: what other versions call otherwise, or no
/// longer have, is left out. @throws ParameterError for a value that is not allowed.
void assignKnown(const std::vector<Parameter>& parameters, const std::vector<NamedText>& values);

/// Writes session.yaml, whole or not at all. @throws std::runtime_error naming the file.
void writeSessionInfo(const std::string& path, const SessionInfo& info);

/// @throws std::runtime_error naming a file that cannot be read, is damaged, or of a newer format.
SessionInfo readSessionInfo(const std::string& path);

}  // namespace revisit_slam
