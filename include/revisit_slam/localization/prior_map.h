// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/loops/association/submap_association.h"
#include "revisit_slam/mapping/submap_library.h"
#include "revisit_slam/session/session_info.h"
#include "revisit_slam/session/stored_local_map.h"
#include "revisit_slam/types/georeference.h"

namespace revisit_slam {

/// The map of an earlier session, as it was left: a value that nothing changes.
struct PriorMap {
  SessionInfo info;
  std::vector<PlacedSubmap> submaps;       ///< without points and normals; common frame: the map
  std::shared_ptr<SubmapLibrary> library;  ///< of these, which reads them from the session's folder
  std::vector<StoredLocalMap>
      places;                     ///< whose features can be compared, and whose submaps are there
  std::vector<Pose> T_map_place;  ///< of these, frames of the local maps
  std::vector<Pose> T_map_scan;   ///< the way that was driven
  std::optional<Georeference> georeference;  ///< where it lies on the earth, if that is known

  /// A submap with its points and normals. @throws std::runtime_error where its file is gone.
  PlacedSubmap whole(const PlacedSubmap& placed) const;
  /// A pose on the ground of the map: height and tilt are those of the nearest scan.
  /// `yaw`: rad, heading from x to y.
  Pose onGround(double x, double y, double yaw) const;
  /// From the nearest scan to `position`, m.
  double distanceTo(const Eigen::Vector3d& position) const;
};
using PriorMapPtr = std::shared_ptr<const PriorMap>;

/// Reads the map of a session with all that localization needs. What cannot be used of it is named
/// in `notices`. `cache_bytes`: of its submaps in memory.
/// @throws std::runtime_error naming the folder and the reason where there is no map to use.
PriorMapPtr loadPriorMap(const std::string& folder, const PlaceRecognitionConfig& recognition,
                         std::size_t cache_bytes, std::vector<std::string>& notices);

/// LocalizationConfig::start as a pose; none where it is empty. @throws ParameterError
std::optional<Pose> startPose(const std::string& start, const PriorMap& map);

}  // namespace revisit_slam
