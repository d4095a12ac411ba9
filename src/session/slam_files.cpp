// SPDX-License-Identifier: MIT
#include "revisit_slam/session/slam_files.h"

#include "revisit_slam/evaluation/consistency_builder.h"
#include "revisit_slam/evaluation/revisit_cells.h"
#include "revisit_slam/io/grid_file.h"
#include "revisit_slam/io/octomap_file.h"
#include "revisit_slam/io/trajectory.h"
#include "revisit_slam/session/graph_files.h"

namespace revisit_slam {
namespace {

/// Larger than submaps are long, so that every passage through a cell has a keypose in it.
constexpr double kConsistencyCell = 40.0;  // m

}  // namespace

SlamFiles::SlamFiles(const std::string& folder, const MappingConfig& mapping,
                     const OccupancyConfig& occupancy)
    : folder_(folder),
      detail_voxel_size_(mapping.detail_voxel_size),
      submaps_(folder + "/submaps"),
      grid_(occupancy.grid),
      occupancy_(occupancy) {}

void SlamFiles::add(const MapUpdate& update) {
  if (update.submap) submaps_.add(update.submap, update.detail_submap);
  if (update.occupancy) occupancy_of_[update.submap->id] = update.occupancy;
}

void SlamFiles::writeGraphFiles(const SlamGraph& graph) const {
  const Trajectory trajectory = trajectoryOf(graph);
  writeTum(file("trajectory.tum"), trajectory);
  writeKitti(file("trajectory_kitti.txt"), trajectory);
  writeGraph(file("pose_graph.g2o"), graph);
  writeLoops(file("loop_closures.csv"), graph);
  submaps_.writeTable(placesOfSubmaps(graph));
}

void SlamFiles::write(const SlamGraph& graph) {
  writeGraphFiles(graph);
  const std::vector<Pose> T_map_submap = placesOfSubmaps(graph);
  submaps_.merge(file("map.pcd"), T_map_submap, detail_voxel_size_);
  if (!occupancy_of_.empty()) writeOccupancy(T_map_submap);
}

void SlamFiles::writeOccupancy(const std::vector<Pose>& T_map_submap) {
  for (const auto& [submap, occupancy] : occupancy_of_)
    occupancy_.place(submap, occupancy, T_map_submap.at(submap.value));
  occupancy_.compose();
  writeOctomap(file("map.bt"), occupancy_);
  writeGrid(file("map"), projectedGrid(occupancy_, grid_));
}

std::vector<Pose> SlamFiles::placesOfSubmaps(const SlamGraph& graph) const {
  std::vector<Pose> T_map_submap;
  for (const SubmapPtr& submap : submaps_.submaps())
    T_map_submap.push_back(graph.pose(submap->first_scan));
  return T_map_submap;
}

MapConsistency SlamFiles::consistency(const SlamGraph& graph) const {
  ConsistencyConfig config;
  config.cell_size = kConsistencyCell;
  ConsistencyBuilder builder(findRevisits(trajectoryOf(graph), config), config);
  const std::vector<Pose> T_map_submap = placesOfSubmaps(graph);
  for (std::size_t i = 0; i < T_map_submap.size(); ++i) {
    const Stamp keypose = submaps_.submaps()[i]->stamps.front();
    if (builder.wants(keypose)) builder.insert(keypose, submaps_.read(i), T_map_submap[i]);
  }
  return builder.finish();
}

}  // namespace revisit_slam
