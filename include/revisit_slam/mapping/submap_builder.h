// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/mapping/mapping_config.h"
#include "revisit_slam/mapping/voxel_mean_grid.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/types/travelled_distance.h"

namespace revisit_slam {

/// How far a trajectory went since its first pose.
class Travel {
 public:
  void start(const Pose& T_odom_base);
  void go(const Pose& T_odom_base);
  /// Whether a map that went this far must end before a scan at `T_odom_base`.
  bool exceeds(const MapSplitConfig& split, const Pose& T_odom_base) const;
  double pathLength() const { return distance_.metres(); }

 private:
  Eigen::Vector3d start_odom_ = Eigen::Vector3d::Zero();
  TravelledDistance distance_;
};

/// The one submap that is being built (paper Sec. III-C).
class SubmapBuilder {
 public:
  explicit SubmapBuilder(double voxel_size) : grid_(voxel_size) {}

  bool empty() const { return submap_.T_submap_scan.empty(); }
  const Travel& travel() const { return travel_; }

  /// The first scan gives the keypose; ids follow each other without gaps.
  void insert(ScanId id, Stamp stamp, const Pose& T_odom_base, const Points& points_base);

  /// The submap as it is now, with its normals; the builder is empty afterwards. Runs in the
  /// current TBB arena.
  Submap close(SubmapId id, LocalMapId local_map);

 private:
  Submap submap_;
  Travel travel_;
  Travel drive_;  // since the origin, through all submaps
  VoxelMeanGrid grid_;
};

}  // namespace revisit_slam
