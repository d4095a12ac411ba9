// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/stamp.h"
#include "revisit_slam/information/registration_problem.h"
#include "revisit_slam/odometry/motion.h"
#include "revisit_slam/odometry/registration.h"

namespace revisit_slam {

/// A scan with its place in the odometry frame; what the odometry hands on.
struct RegisteredScan {
  ScanId id;
  /// A number for the run of the odometry, which counts scans from 0: another one after a reset.
  std::int64_t session = 0;
  std::string sensor_frame;  ///< frame_id of the message
  Stamp stamp;  ///< the instant at which the pose is valid
  Pose T_odom_base;
  Tangent velocity_base = Tangent::Zero();  ///< [m/s; rad/s], mean since the previous scan
  /// What the motion that the scan was deskewed with missed: Log(T_odom_deskewed^-1 * T_odom_base).
  Tangent deskew_error = Tangent::Zero();
  Points points_base;       ///< all points in range, deskewed to `stamp`
  Eigen::Vector3d sensor_base = Eigen::Vector3d::Zero();  ///< where the points were seen from
  Points source_base;       ///< the down-sampled points that were registered
  RegistrationResult registration;
  double sigma = 0.0;       ///< m, the adaptive threshold that the registration used
  bool deskewed = false;
  /// The registration, taken out of the map: what the information is estimated from. Without points
  /// where information is switched off, and at the first scan.
  RegistrationProblem problem;
};

}  // namespace revisit_slam
