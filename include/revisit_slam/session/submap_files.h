// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// The submaps of a drive as files, NNNNNN.pcd in their own frames: written once, when they are
/// closed, and never again, whatever the graph does. What is on disk survives a crash.
class SubmapFiles {
 public:
  /// Makes the folder. @throws std::runtime_error naming it.
  explicit SubmapFiles(const std::string& folder);

  /// Ids count from 0 without gaps. @throws std::runtime_error naming the file.
  void add(const SubmapPtr& submap, const Points& detail_submap);

  /// What was added as the detail of a submap. @throws std::runtime_error naming the file.
  Points read(std::size_t submap) const;

  /// submaps.csv: which scans a submap has, and where it lies, by SubmapId.
  void writeTable(const std::vector<Pose>& T_map_submap) const;

  /// One cloud of all submaps at these poses, one point for each voxel, whole or not at all. Holds
  /// a part of the map of 200 m x 200 m at a time.
  void merge(const std::string& path, const std::vector<Pose>& T_map_submap,
             double voxel_size) const;

  const std::vector<SubmapPtr>& submaps() const { return submaps_; }

 private:
  std::string file(std::size_t submap) const;

  std::string folder_;
  std::vector<SubmapPtr> submaps_;
  std::vector<Eigen::AlignedBox3f> boxes_submap_;
};

}  // namespace revisit_slam
