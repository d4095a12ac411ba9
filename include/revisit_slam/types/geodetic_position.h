// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// On the WGS84 ellipsoid.
struct GeodeticPosition {
  double latitude = 0.0;   ///< deg, north
  double longitude = 0.0;  ///< deg, east
  double altitude = 0.0;   ///< m above the ellipsoid
};

inline bool areEqual(const GeodeticPosition& a, const GeodeticPosition& b) {
  return a.latitude == b.latitude && a.longitude == b.longitude && a.altitude == b.altitude;
}

}  // namespace revisit_slam
