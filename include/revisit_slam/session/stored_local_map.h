// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/io/record_file.h"
#include "revisit_slam/loops/recognition/place_recognition.h"

namespace revisit_slam {

/// What a session keeps of a local map: the points of the submaps are in their own files.
struct StoredLocalMap {
  LocalMapId id;
  std::vector<SubmapId> submaps;  ///< in order
  /// As place recognition compares it; without features where loops are switched off.
  Pose T_level_local;
  double pixel = 0.0;  ///< m, edge of a pixel of the keypoints
  PlaceFeatures features;
};

/// `view`: null where loops are switched off.
StoredLocalMap storedLocalMap(const LocalMap& map, const PlaceView* view);

/// The records of a local map's file, of types 1 and 2.
std::vector<Record> recordsOf(const StoredLocalMap& map);
/// The local maps that are among records: each begins with one of type 1.
std::vector<StoredLocalMap> localMapsOf(const std::vector<Record>& records);

/// A local map as bytes of its file, NNNN.rsm.
std::string encodeLocalMap(const StoredLocalMap& map);

/// @throws std::runtime_error naming a file that cannot be read, or is damaged.
StoredLocalMap readLocalMap(const std::string& path);

}  // namespace revisit_slam
