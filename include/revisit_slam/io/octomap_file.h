// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/occupancy/occupancy_map.h"

namespace revisit_slam {

/// Writes the map as a binary octree of OctoMap (.bt: `octovis FILE`, `octomap::OcTree`), as
/// OctoMap itself writes it: each node occupied, free or unknown, and equal children in one. Made
/// straight from the blocks, since an octree in memory takes tens of megabytes for a kilometre.
/// @throws std::runtime_error naming the file, or where the map is larger than an octree of 16
/// levels: 32768 voxels from the origin.
void writeOctomap(const std::string& path, const OccupancyMap& map);

}  // namespace revisit_slam
