// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "revisit_slam/evaluation/nearest_distances.h"
#include "revisit_slam/evaluation/plane_thickness.h"
#include "revisit_slam/evaluation/revisit_cells.h"

namespace revisit_slam {

/// How well the local maps of a place agree that were made at different times.
struct CellConsistency {
  RevisitCell cell;
  std::vector<NearestDistances> pairs;  ///< of comparable segments, each in both directions
  NearestDistances distances;           ///< their sum
  PlaneThickness thickness;             ///< of all segments together
};

/// Of values in m; mean and (population) standard deviation are NaN without any.
struct RmsStatistics {
  std::size_t count = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;
};

/// The local maps of one cell, one for each of its segments.
struct CellMaps {
  RevisitCell cell;
  /// Where the estimate entered the cell first: the frame of the maps.
  Pose T_world_cell;
  std::vector<Points> maps;
};

/// Revisit map consistency of one estimate (paper Sec. IV-C).
struct MapConsistency {
  std::vector<CellConsistency> cells;  ///< with pairs, in the order of the revisits
  std::size_t cells_without_pairs = 0;
  /// Of the RMS of each pair of local maps, as the paper prints it.
  RmsStatistics of_pairs;
  /// Ours: of the RMS of each cell, its pairs pooled. A place counts once, however often it was
  /// visited.
  RmsStatistics of_cells;
  /// Ours: independent of nearest neighbours.
  PlaneThickness thickness;
  /// Points that found a partner, of all points that looked for one, all cells.
  double share = 0.0;
  std::vector<CellMaps> worst;  ///< largest RMS first
};

MapConsistency summarise(std::vector<CellConsistency> cells, std::vector<CellMaps> worst);

}  // namespace revisit_slam
