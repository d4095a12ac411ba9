// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/types/georeference.h"

namespace revisit_slam {

/// In a folder: georeference.yaml, where the map lies on the earth; trajectory_enu.tum, in the
/// frame of east, north and up at the datum; trajectory_utm.csv, latitude, longitude, altitude and
/// coordinates in the zone of UTM of the datum (not near the poles).
/// @throws std::runtime_error naming a file that cannot be written.
void writeGeoreference(const std::string& folder, const Trajectory& trajectory_map,
                       const Georeference& georeference);

}  // namespace revisit_slam
