// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "revisit_slam/types/geodetic_position.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Where a map lies on the earth.
struct Georeference {
  GeodeticPosition datum;  ///< origin of the frame enu: x east, y north, z up
  Pose T_enu_map;
  double yaw_deviation = 0.0;  ///< rad, standard deviation of its yaw by the errors of the fixes
  std::size_t fixes = 0;       ///< that it was estimated from
  std::size_t outliers = 0;    ///< of these, left out by their robust kernel
};

}  // namespace revisit_slam
