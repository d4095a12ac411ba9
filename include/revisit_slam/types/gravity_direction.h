// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// Where the accelerometer of an inertial unit has the sky, at a scan.
struct GravityDirection {
  ScanId scan;
  Eigen::Vector3d up_base = Eigen::Vector3d::UnitZ();  ///< unit vector, in the base frame
};

}  // namespace revisit_slam
