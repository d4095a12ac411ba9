// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/occupancy/projected_grid.h"

namespace revisit_slam {

/// Writes `name`.pgm and `name`.yaml as map_server reads and map_saver writes them: row 0 on top is
/// the largest y; 254 free, 0 occupied, 205 unknown. Whole or not at all.
/// @throws std::runtime_error naming the file.
void writeGrid(const std::string& name, const ProjectedGrid& grid);

}  // namespace revisit_slam
