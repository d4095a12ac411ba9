// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// On the WGS84 ellipsoid.
struct GeodeticPosition {
  double latitude = 0.0;   ///< deg, north
  double longitude = 0.0;  ///< deg, east
  double altitude = 0.0;   ///< m above the ellipsoid
};

}  // namespace revisit_slam
