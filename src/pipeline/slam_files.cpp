// SPDX-License-Identifier: MIT
#include "revisit_slam/pipeline/slam_files.h"

#include "revisit_slam/io/graph_files.h"
#include "revisit_slam/io/trajectory.h"

namespace revisit_slam {

SlamFiles::SlamFiles(const std::string& folder, const MappingConfig& config)
    : folder_(folder),
      detail_voxel_size_(config.detail_voxel_size),
      submaps_(folder + "/submaps") {}

void SlamFiles::add(const MapUpdate& update) {
  if (update.submap) submaps_.add(update.submap, update.detail_submap);
}

void SlamFiles::write(const BackEnd& back_end) const {
  writeGraphFiles(back_end);
  submaps_.merge(file("map.pcd"), placesOfSubmaps(back_end), detail_voxel_size_);
}

void SlamFiles::writeGraphFiles(const BackEnd& back_end) const {
  const Trajectory trajectory = back_end.trajectory();
  writeTum(file("trajectory.tum"), trajectory);
  writeKitti(file("trajectory_kitti.txt"), trajectory);
  writeGraph(file("pose_graph.g2o"), back_end.graph());
  writeLoops(file("loop_closures.csv"), back_end.graph());
  submaps_.writeTable(placesOfSubmaps(back_end));
}

std::vector<Pose> SlamFiles::placesOfSubmaps(const BackEnd& back_end) const {
  std::vector<Pose> T_map_submap;
  for (const SubmapPtr& submap : submaps_.submaps())
    T_map_submap.push_back(back_end.graph().pose(submap->first_scan));
  return T_map_submap;
}

}  // namespace revisit_slam
