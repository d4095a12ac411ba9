// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/occupancy/octree.h"

namespace revisit_slam {

/// Writes the map as a binary octree of OctoMap (.bt: `octovis FILE`, `octomap::OcTree`), byte for
/// byte what `octomap::OcTree::writeBinary` writes.
/// @throws std::runtime_error naming the file, or where the map is larger than an octree of 16
/// levels (octreeOf).
void writeOctomap(const std::string& path, const OccupancyVoxels& map);
void writeOctomap(const std::string& path, const octomap::OcTree& tree);

}  // namespace revisit_slam
