// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "revisit_slam/evaluation/map_consistency.h"
#include "revisit_slam/mapping/map_builder.h"
#include "revisit_slam/occupancy/occupancy_map.h"
#include "revisit_slam/pose_graph/slam_graph.h"
#include "revisit_slam/session/submap_files.h"

namespace revisit_slam {

/// The maps and the graph of a drive in a folder: submaps while the drive goes on, the rest as
/// often as it is asked for.
class SlamFiles {
 public:
  /// @throws std::runtime_error naming a folder that cannot be made.
  SlamFiles(const std::string& folder, const MappingConfig& mapping,
            const OccupancyConfig& occupancy);

  /// Writes what was closed. @throws std::runtime_error naming the file.
  void add(const MapUpdate& update);

  /// trajectory.tum, trajectory_kitti.txt, pose_graph.g2o, loop_closures.csv and
  /// submaps/submaps.csv, each whole or not at all: all that the graph says, quickly.
  /// @throws std::runtime_error naming the file.
  void writeGraphFiles(const SlamGraph& graph) const;

  /// The same and map.pcd, and of the occupancy map.bt, map.pgm and map.yaml.
  void write(const SlamGraph& graph);

  /// How well the map agrees with itself where the drive came back (paper Sec. IV-C), with the
  /// revisits of the corrected trajectory itself and submaps as what is compared.
  MapConsistency consistency(const SlamGraph& graph) const;

  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  const std::vector<SubmapPtr>& submaps() const { return submaps_.submaps(); }
  /// The points of a submap as they were added, in its frame. @throws std::runtime_error
  Points detail(SubmapId id) const { return submaps_.read(id.value); }

 private:
  std::vector<Pose> placesOfSubmaps(const SlamGraph& graph) const;
  void writeOccupancy(const std::vector<Pose>& T_map_submap);

  std::string folder_;
  double detail_voxel_size_;
  SubmapFiles submaps_;
  ProjectedGridConfig grid_;
  std::map<SubmapId, SubmapOccupancyPtr> occupancy_of_;
  OccupancyMap occupancy_;
};

}  // namespace revisit_slam
