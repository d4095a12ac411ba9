// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "revisit_slam/types/stamp.h"
#include "revisit_slam/occupancy/occupancy_map.h"
#include "revisit_slam/occupancy/projected_grid.h"

namespace revisit_slam {

nav_msgs::OccupancyGrid toOccupancyGrid(const ProjectedGrid& grid, Stamp stamp,
                                        const std::string& frame);

/// Cubes for the occupied voxels, coloured by height; one marker, which replaces the one before.
visualization_msgs::MarkerArray toVoxelMarkers(const OccupancyMap& map, Stamp stamp,
                                               const std::string& frame);

}  // namespace revisit_slam
