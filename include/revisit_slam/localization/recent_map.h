// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <vector>

#include "revisit_slam/mapping/map_scale.h"
#include "revisit_slam/mapping/voxel_mean_grid.h"
#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/types/submap.h"
#include "revisit_slam/types/travelled_distance.h"

namespace revisit_slam {

/// The scans of the last metres, kept in slices so that each is added up once and any number of
/// last metres can be had as one submap. Of scans within a metre the first is enough.
class RecentMap {
 public:
  /// Keeps `length` m; voxels have an edge of `voxel_size` m in places of full size.
  RecentMap(double voxel_size, double length, const MapScale& scale = {})
      : voxel_size_(voxel_size), length_(length), scale_(scale) {}

  /// Scans of one session, in order.
  void insert(const RegisteredScan& scan);
  /// Ends the slice that is open, and forgets what is too old.
  void cut();

  /// Travelled since the first scan, m.
  double travelled() const { return travelled_.metres(); }
  /// Of the slice that is open, m.
  double open() const { return open_.T_odom_scan.empty() ? 0.0 : travelled() - open_.begin; }
  /// How much of that is kept, m.
  double kept() const;

  /// The slices of the last `metres`, in the frame of the newest scan, with normals. Its trajectory
  /// ends with that scan. Runs in the current TBB arena.
  Submap submap(double metres) const;
  /// The same as a local map of one submap, as places are recognised by.
  LocalMap localMap(double metres) const;

 private:
  struct Slice {
    double begin = 0.0;  // m, travelled
    double scale = 1.0;  // of its voxels
    Pose T_odom_slice;
    std::vector<Pose> T_odom_scan;
    std::vector<Stamp> stamps;
    Points points;  // in its frame
  };

  VoxelMeanGrid joined(double metres) const;
  double newestScale() const { return slices_.empty() ? 1.0 : slices_.back().scale; }

  double voxel_size_, length_;
  MapScale scale_;
  TravelledDistance travelled_;
  bool has_scans_ = false;
  ScanId newest_;
  Pose T_odom_newest_;
  Eigen::Vector3d sensor_base_ = Eigen::Vector3d::Zero();
  double added_at_ = 0.0;  // m, travelled: the newest scan whose points were added
  std::deque<Slice> slices_;
  Slice open_;
  VoxelMeanGrid grid_{voxel_size_};
};

}  // namespace revisit_slam
