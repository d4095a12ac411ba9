// SPDX-License-Identifier: MIT
#include "revisit_slam/pipeline/slam_files.h"

#include "revisit_slam/io/graph_files.h"
#include "revisit_slam/io/grid_file.h"
#include "revisit_slam/io/octomap_file.h"
#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {

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

void SlamFiles::write(const BackEnd& back_end) {
  const Trajectory trajectory = back_end.trajectory();
  writeTum(file("trajectory.tum"), trajectory);
  writeKitti(file("trajectory_kitti.txt"), trajectory);
  writeGraph(file("pose_graph.g2o"), back_end.graph());
  writeLoops(file("loop_closures.csv"), back_end.graph());
  std::vector<Pose> T_map_submap;
  for (const SubmapPtr& submap : submaps_.submaps())
    T_map_submap.push_back(back_end.graph().pose(submap->first_scan));
  submaps_.writeTable(T_map_submap);
  submaps_.merge(file("map.pcd"), T_map_submap, detail_voxel_size_);
  for (const auto& [submap, occupancy] : occupancy_of_)
    occupancy_.place(submap, occupancy, T_map_submap.at(submap.value));
  if (!occupancy_of_.empty()) writeOccupancy();
}

void SlamFiles::writeOccupancy() {
  occupancy_.compose();
  writeOctomap(file("map.bt"), occupancy_);
  writeGrid(file("map"), projectedGrid(occupancy_, grid_));
}

}  // namespace revisit_slam
