// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/simulation/polyline.h"

namespace revisit_slam::simulation {

/// Positions of a recorded drive, x forward, y left, z up, beginning at the origin in xy.
struct RecordedRoute {
  /// Seconds from the first.
  std::vector<double> times;
  Polyline positions;
};

/// Reads a TUM trajectory (stamp tx ty tz qx qy qz qw) or a KITTI pose file (3x4 rows of the camera
/// frame, x right, y down, z forward, at 10 Hz); the number of columns tells which.
/// @throw ParameterError naming the file and the line.
RecordedRoute readRoute(const std::string& path);

}  // namespace revisit_slam::simulation
