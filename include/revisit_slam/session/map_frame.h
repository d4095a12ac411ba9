// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "revisit_slam/io/cloud_file.h"
#include "revisit_slam/types/georeference.h"

namespace revisit_slam {

/// The frame that a map is exported in.
struct MapFrame {
  /// map: the session's own. enu: east, north and up at the datum. utm: easting and northing of
  /// WGS 84 / UTM, and height above the ellipsoid.
  enum class Kind { map, enu, utm };

  Kind kind = Kind::map;
  std::optional<int> utm_zone;  ///< 1 to 60; none: the one of the datum
};

/// @throws std::invalid_argument for another name.
MapFrame::Kind mapFrameKind(const std::string& name);

/// For clouds written from points in the frame of the map, in one of `format`.
/// @throws std::invalid_argument where the map has no georeference but the frame needs one, where
/// the zone is not there, and for a format of single precision in UTM.
CloudFrame cloudFrameOf(const MapFrame& frame, const std::optional<Georeference>& georeference,
                        const std::string& format);

}  // namespace revisit_slam
