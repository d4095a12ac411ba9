// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "revisit_slam/types/geodetic_position.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A measured position of an antenna, tied by odometry to a scan before it.
struct GnssFix {
  Stamp stamp;
  ScanId scan;
  /// The antenna at `stamp`, in the base frame at the scan, m.
  Eigen::Vector3d p_scan = Eigen::Vector3d::Zero();
  GeodeticPosition position;
  Eigen::Matrix3d covariance_enu = Eigen::Matrix3d::Identity();  ///< m^2, of east, north, up
};

}  // namespace revisit_slam
