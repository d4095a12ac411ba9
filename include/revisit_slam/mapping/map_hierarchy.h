// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/mapping/submap_builder.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// What a call closed; null where nothing was. A local map ends with the submap beside it.
struct ClosedMaps {
  SubmapPtr submap;
  LocalMapPtr local_map;
};

/// Cuts the drive into submaps, and these into local maps (paper Sec. III-C). Ids count from 0.
/// Where the surroundings are narrow both are smaller, as their first scan says, and so are their
/// voxels. Where the odometry has lost its track both end: within them poses are held to be right.
class MapHierarchy {
 public:
  explicit MapHierarchy(const MappingConfig& config)
      : config_(config), builder_(config.submap_voxel_size) {}

  /// Closes what must end before this scan, then adds the scan to the open submap. Closing runs in
  /// the current TBB arena.
  ClosedMaps insert(ScanId id, Stamp stamp, const Pose& T_odom_base, const Points& points_base,
                    const SubmapStart& start = {});

  /// Closes what is open, if anything: at the end of a drive, or on request. The next scan begins
  /// new maps.
  ClosedMaps closeAll();

 private:
  SubmapPtr closeSubmap();
  LocalMapPtr closeLocalMap();

  MappingConfig config_;
  SubmapBuilder builder_;
  SubmapId next_submap_;
  LocalMap open_;
  Travel travel_;                    // since the first scan of the open local map
  double size_ = 1.0, scale_ = 1.0;  // of the open local map
};

/// Union of the points of the submaps, placed by the odometry: one mean for each voxel, in the
/// frame of the first submap.
Points unionOfPoints(const std::vector<SubmapPtr>& submaps, double voxel_size);

}  // namespace revisit_slam
