// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/loops/recognition/place_recognition.h"
#include "revisit_slam/mapping/submap_library.h"
#include "revisit_slam/session/session_numbers.h"
#include "revisit_slam/session/session_reader.h"
#include "revisit_slam/session/session_writer.h"

namespace revisit_slam {

/// All that loops and graph need of a folder's sessions to go on with them: a value.
struct KnownMap {
  Session session;  ///< up to the last closed submap, with the ids that it has in its folder
  SessionNumbers numbers;

  // With the ids that it gets:
  std::vector<GraphNode> nodes;
  std::vector<LoopEdge> loops;
  std::vector<LocalMapPtr> maps;           ///< without points, nor have their submaps any
  std::vector<PlaceView> places;           ///< of these, without picture
  std::shared_ptr<SubmapLibrary> library;  ///< reads the submaps, and keeps none in memory
};
using KnownMapPtr = std::shared_ptr<const KnownMap>;

/// What loops need of a submap: trajectory, points and normals, with the ids that it has in its
/// folder, which belongs to `owner`. @throws std::runtime_error where its file is damaged, or
/// another one than the log says.
Submap readForLoops(const std::string& folder, SessionId owner, const SubmapClosed& closed);

/// The number that a session gets that goes on from these.
SessionId nextSession(const SessionInfo& info);

/// Reads the sessions of a folder, which are numbered from `first` on, or stay what they are. What
/// cannot be used of it is named in `notices`.
/// @throws std::runtime_error naming the folder and the reason where there is nothing to go on
/// with.
KnownMap readKnownMap(const std::string& folder, std::optional<SessionId> first,
                      const PlaceRecognitionConfig& recognition, std::vector<std::string>& notices);

/// What session.yaml says of the sessions of known maps in one folder, which belongs to the first.
SessionInfo infoOfAll(const std::vector<const KnownMap*>& maps);

/// Copies submaps and local maps, and the scans of the graph. Where fine points or occupancy can no
/// longer be read, the points that loops are registered with take their place; where these cannot
/// either, the submap has no file, which readers name. `reads_copies`: from then on the map's
/// library reads the copies.
void copyMaps(const KnownMap& map, SessionWriter& writer, bool reads_copies = false);

}  // namespace revisit_slam
