// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "revisit_slam/evaluation/map_consistency.h"
#include "revisit_slam/session/map_frame.h"
#include "revisit_slam/session/session_reader.h"

namespace revisit_slam {

/// What is made of a session.
struct ExportConfig {
  bool graph = true;  ///< trajectories, pose_graph.g2o, loop_closures.csv, submaps.csv
  std::set<std::string> clouds{"pcd"};  ///< of the map: pcd, ply, las
  MapFrame frame;                       ///< of the clouds of the map
  bool submaps = true;                  ///< each as a cloud of its own
  bool occupancy = true;                ///< map.bt, map.pgm, map.yaml
  /// Points of what moved go to map_dynamic.* instead of map.*, and out of the occupancy; so they
  /// do where the parameter mapping/dynamic_points/remove of the session says so.
  bool remove_dynamic = false;
  std::optional<double>
      resolution;              ///< m, edge of a voxel of the clouds; none: as finely as stored
  std::optional<double> tile;  ///< m, edge of the squares that clouds are cut into; none: one
};

/// Is told how much of the whole is done, 0 to 1.
using ExportProgress = std::function<void(double share)>;

/// Makes files of a session in a folder, which is made if missing, each whole or not at all.
/// @return what could not be made or used, and why.
/// @throws std::runtime_error naming a file that cannot be written, std::invalid_argument where
/// clouds cannot be in the frame.
std::vector<std::string> exportSession(const Session& session, const std::string& folder,
                                       const ExportConfig& config = {},
                                       const ExportProgress& progress = {});

/// How well the map agrees with itself where the drive came back (paper Sec. IV-C), with the
/// revisits of the corrected trajectory itself and submaps as what is compared. Of a single
/// session.
MapConsistency consistencyOf(const Session& session);

}  // namespace revisit_slam
