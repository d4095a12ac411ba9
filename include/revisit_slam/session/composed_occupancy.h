// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/occupancy/occupancy_voxels.h"
#include "revisit_slam/occupancy/submap_occupancy.h"
#include "revisit_slam/session/session_reader.h"

namespace revisit_slam {

/// The occupancy of a submap; null where there is none. Is asked more than once.
using ReadOccupancy = std::function<SubmapOccupancyPtr(const SubmapClosed& submap)>;

/// The occupancy of the whole map of a session, bit for bit that of OccupancyMap, with one submap
/// and a square of 200 m of the evidence in memory at a time.
/// @throws std::invalid_argument for submaps of another resolution than the map's.
OccupancyVoxels composedOccupancy(const Session& session, const OccupancyConfig& config,
                                  const ReadOccupancy& read);

}  // namespace revisit_slam
