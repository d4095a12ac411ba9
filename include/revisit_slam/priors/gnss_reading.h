// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "revisit_slam/types/geodetic_position.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// A position that a GNSS receiver measured.
struct GnssReading {
  Stamp stamp;
  GeodeticPosition position;                                     ///< of the antenna
  Eigen::Matrix3d covariance_enu = Eigen::Matrix3d::Identity();  ///< m^2, of east, north, up
  Eigen::Vector3d p_base = Eigen::Vector3d::Zero();              ///< the antenna in the base frame
};

}  // namespace revisit_slam
