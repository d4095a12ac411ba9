// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/odometry/motion.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/odometry/sweep_motion.h"
#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// A scan's points in the base frame at the scan's stamp.
struct PreprocessedScan {
  Points points_base;
  /// Of each point: the time from when it was seen to the stamp, as a fraction of the time since
  /// the previous scan, at most 1. Empty where nothing was deskewed or there is no such time.
  std::vector<float> sweep_fractions;
  std::vector<float> intensities;  ///< of each point, or none
  std::size_t too_near = 0;
  std::size_t too_far = 0;
  std::size_t on_body = 0;
  std::vector<PointsView> views;  ///< those of the scan
  bool deskewed = false;
};

/// Drops points out of range of the sensor, expresses the others in the base frame and moves each
/// to where it would have been seen at the scan's stamp, had the base moved with `motion_base`, or
/// with `sweep` where that is given.
/// `seconds_since_previous`: scan; 0: there is none that times could be related to.
PreprocessedScan preprocess(const Scan& scan, const ConstantMotion& motion_base,
                            const OdometryConfig& config, double seconds_since_previous = 0.0,
                            const SweepMotion* sweep = nullptr);

}  // namespace revisit_slam
