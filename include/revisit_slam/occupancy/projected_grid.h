// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "revisit_slam/occupancy/occupancy_config.h"
#include "revisit_slam/occupancy/occupancy_voxels.h"

namespace revisit_slam {

/// The map seen from above, laid out as nav_msgs/OccupancyGrid has it: row by row in x, rows in y.
struct ProjectedGrid {
  static constexpr std::int8_t kUnknown = -1, kFree = 0, kOccupied = 100;

  /// Corner of cell (0, 0) with the lowest x and y, in the map frame, metres.
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double resolution = 0.0;
  int width = 0;
  int height = 0;
  std::vector<std::int8_t> cells;
};

/// Heights are counted from the top of the ground's voxel (GroundHeights), not from the map's zero.
/// A column with an occupied voxel in the band is occupied, else one with a free voxel there is
/// free, and so is one in which the robot drove, whatever was seen above it: dust, or a table that
/// it went under. Where levels lie above each other the lowest is shown.
/// @throws std::length_error where there would be more than `most_cells`, of one byte each.
ProjectedGrid projectedGrid(const OccupancyVoxels& map, const ProjectedGridConfig& config,
                            double most_cells = 1e9);

}  // namespace revisit_slam
