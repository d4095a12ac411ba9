// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <visualization_msgs/MarkerArray.h>
#ifdef REVISIT_SLAM_OCTOMAP_MSGS
#include <octomap_msgs/Octomap.h>
#endif

#include <string>

#include "revisit_slam/occupancy/occupancy_voxels.h"
#include "revisit_slam/occupancy/projected_grid.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

nav_msgs::OccupancyGrid toOccupancyGrid(const ProjectedGrid& grid, Stamp stamp,
                                        const std::string& frame);

/// Cubes for the occupied voxels, coloured by height; one marker, which replaces the one before.
visualization_msgs::MarkerArray toVoxelMarkers(const OccupancyVoxels& map, Stamp stamp,
                                               const std::string& frame);

#ifdef REVISIT_SLAM_OCTOMAP_MSGS
/// A binary octree, as `map.bt` has it. @throws std::runtime_error as octreeOf() does.
octomap_msgs::Octomap toOctomap(const OccupancyVoxels& map, Stamp stamp, const std::string& frame);
#endif

}  // namespace revisit_slam
