// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/core/scan.h"
#include "revisit_slam/odometry/motion.h"
#include "revisit_slam/odometry/odometry_config.h"

namespace revisit_slam {

/// A scan's points in the base frame at the scan's stamp.
struct PreprocessedScan {
  Points points_base;
  std::size_t too_near = 0;
  std::size_t too_far = 0;
  bool deskewed = false;
};

/// Drops points out of range of the sensor, expresses the others in the base frame and moves each
/// to where it would have been seen at the scan's stamp, had the base moved with `motion_base`.
PreprocessedScan preprocess(const Scan& scan, const ConstantMotion& motion_base,
                            const OdometryConfig& config);

}  // namespace revisit_slam
