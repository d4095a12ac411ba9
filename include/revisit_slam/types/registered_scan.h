// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "revisit_slam/types/gnss_fix.h"
#include "revisit_slam/types/gravity_direction.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/pose_verdict.h"
#include "revisit_slam/types/registration_result.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

struct KnownMap;

/// Points that one of several sensors saw, and follow one another.
struct PointsView {
  Eigen::Vector3d sensor_base;
  std::size_t end = 0;  ///< behind the last of them
};

/// A scan with its place in the odometry frame; what the odometry hands on.
struct RegisteredScan {
  /// Scans of a base that rests repeat the id of the one before: maps and graph leave them out.
  ScanId id;
  std::string sensor_frame;  ///< frame_id of the message
  Stamp stamp;               ///< the instant at which the pose is valid
  Pose T_odom_base;
  Tangent velocity_base = Tangent::Zero();  ///< [m/s; rad/s], mean since the previous scan
  /// What the motion that the scan was deskewed with missed: Log(T_odom_deskewed^-1 * T_odom_base).
  Tangent deskew_error = Tangent::Zero();
  /// Of the predicted motion, for right perturbations [m; rad] in the base frame; zero: nothing is
  /// known.
  Matrix6 prior_information = Matrix6::Zero();
  RegistrationResult registration;
  double seconds_since_previous = 0.0;  ///< 0 for the first scan
  Points points_base;                   ///< all points in range, deskewed to `stamp`
  std::vector<float> intensities;       ///< of these, or none
  Eigen::Vector3d sensor_base = Eigen::Vector3d::Zero();  ///< where the points were seen from
  /// Of several sensors: from where the points that follow one another were. Empty: from above.
  std::vector<PointsView> views;
  Points source_base;  ///< the down-sampled points that were registered
  /// Deviation of the pose from the prediction, in standard deviations of both, the larger of
  /// translation and rotation; 0 where nothing is known of the motion.
  double jump = 0.0;
  double voxel_size = 0.0;  ///< m, edge of the local map's voxels that it was registered with
  double sigma = 0.0;       ///< m, the adaptive threshold that the registration used
  PoseVerdict verdict = PoseVerdict::good;  ///< as far as the registration tells
  bool deskewed = false;
  std::vector<GnssFix> fixes;               ///< that are due with it, of scans before
  std::optional<GravityDirection> gravity;  ///< that is due with it, of a scan before
  /// Of the first scan of a session: the map that the session goes on from; else null.
  std::shared_ptr<const KnownMap> goes_on_from;
};

using RegisteredScanPtr = std::shared_ptr<const RegisteredScan>;

}  // namespace revisit_slam
