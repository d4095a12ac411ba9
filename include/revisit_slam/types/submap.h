// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// What the drift of the odometry depends on besides the travelled distance, since the session
/// began.
struct UnsureDistance {
  double weak = 0.0;         ///< m, travelled while scans hardly held the place in the plane
  double weak_height = 0.0;  ///< m, travelled while they hardly held the height
  double doubt = 0.0;  ///< m, standard deviations of the motions of poor and lost scans, summed
};

/// A stretch of about 25 m (paper Sec. III-C: S_k), closed and immutable. Its frame is the base
/// frame at its first scan, the keypose. Where that frame lies in the map is known to the graph
/// alone.
struct Submap {
  SubmapId id;
  LocalMapId local_map;
  ScanId first_scan;
  /// Travelled distance of the odometry at the first and at the last scan, m.
  double travelled_begin = 0.0, travelled_end = 0.0;
  UnsureDistance unsure_begin;  ///< at the first scan
  /// Of its voxels and what it is registered with, as a share of the configured: below 1 in rooms.
  double scale = 1.0;
  /// Keypose as the odometry had it.
  Pose T_odom_submap;
  /// Gamma_k: one pose for each scan from first_scan on, without gaps; the first is the identity.
  std::vector<Pose> T_submap_scan;
  std::vector<Stamp> stamps;
  /// One point (the mean) for each occupied voxel of edge scale * nu_sub, in the submap frame.
  Points points;
  /// Unit normals of the points, on the side that was seen; zero where the neighbourhood has none.
  Points normals;

  ScanId lastScan() const {
    return {first_scan.value + static_cast<std::uint32_t>(T_submap_scan.size()) - 1,
            first_scan.session};
  }
};

using SubmapPtr = std::shared_ptr<const Submap>;

/// A stretch of about 100 m (paper Sec. III-C: M_n) made of whole submaps, closed and immutable.
/// Its frame is that of its first submap.
struct LocalMap {
  LocalMapId id;
  /// I_n, in order.
  std::vector<SubmapPtr> submaps;
  /// One point (the mean) for each occupied voxel of edge nu_loc, in the local map's frame.
  Points points;
  /// Nothing ties its pose to the local maps before: the odometry had lost its track.
  bool after_loss = false;

  const Pose& T_odom_local() const { return submaps.front()->T_odom_submap; }
};

using LocalMapPtr = std::shared_ptr<const LocalMap>;

}  // namespace revisit_slam
