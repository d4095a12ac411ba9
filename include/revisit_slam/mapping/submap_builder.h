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

/// What a submap takes over from its first scan besides the pose.
struct SubmapStart {
  double size = 1.0;   ///< of submaps and local maps, as a share of the configured one
  double scale = 1.0;  ///< of their voxels, likewise
  UnsureDistance unsure;
  bool after_loss = false;  ///< nothing ties the pose to those before: a new local map begins
  Eigen::Vector3d sensor_base = Eigen::Vector3d::Zero();  ///< where points are seen from
};

/// The one submap that is being built (paper Sec. III-C).
class SubmapBuilder {
 public:
  explicit SubmapBuilder(double voxel_size) : voxel_size_(voxel_size), grid_(voxel_size) {}

  bool empty() const { return submap_.T_submap_scan.empty(); }
  const Travel& travel() const { return travel_; }
  double size() const { return size_; }

  /// The first scan gives the keypose; ids follow each other without gaps.
  void insert(ScanId id, Stamp stamp, const Pose& T_odom_base, const Points& points_base,
              const SubmapStart& start = {});

  /// The submap as it is now, with its normals; the builder is empty afterwards. Runs in the
  /// current TBB arena.
  Submap close(SubmapId id, LocalMapId local_map);

 private:
  double voxel_size_;
  double size_ = 1.0;
  Eigen::Vector3d sensor_base_ = Eigen::Vector3d::Zero();
  Submap submap_;
  Travel travel_;
  Travel drive_;  // since the origin, through all submaps
  VoxelMeanGrid grid_;
};

}  // namespace revisit_slam
