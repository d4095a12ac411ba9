// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/icp/cached_match.h"
#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/icp/ring_spacing.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/odometry/ring_limit.h"
#include "revisit_slam/odometry/scan_objective.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/registration_result.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// What is known of a pose before the registration.
struct PosePrediction {
  PosePrediction(const Pose& T_odom_base) : T_odom_base(T_odom_base) {}  // NOLINT: a pose is one

  Pose T_odom_base;
  /// Of Log(T_odom_base^-1 T_odom_true), where the motion was measured: weighed in any case.
  std::optional<Matrix6> information;
  /// Whether registrations before have seen the motion (RingLimit).
  bool motion_is_seen = true;
};

/// ICP of a scan to the local map (paper Eq. 1-2; KISS-ICP Sec. III-C) over right perturbations
/// T * Exp(d). Each iteration matches the points and adds up their normal equations
/// (ScanObjective), takes a Gauss-Newton step of the pose and of the deskew correction
/// (deskew_correction.h), and reduces sigma where ICP has converged (AnnealedSigma). Where too few
/// matches are left at a reduced sigma, the pose of the larger one is the result.
class Registration {
 public:
  explicit Registration(const RegistrationConfig& config) : config_(config) {}

  /// m: points without a map point nearer than this are not matched.
  static double maxCorrespondenceDistance(double sigma) {
    return ScanObjective::maxDistance(sigma);
  }

  /// `sweep_fractions`: one for each point, or none; a prediction without information is then the
  /// first guess alone. `initial_sigma` in metres. `rings`: of the sensor that saw the points. Runs
  /// in the current TBB arena; the same bits for any number of threads.
  RegistrationResult align(const Points& points_base, const std::vector<float>& sweep_fractions,
                           const LocalVoxelMap& map, const PosePrediction& predicted,
                           double initial_sigma, const RingSpacing& rings = {});

 private:
  RegistrationConfig config_;
  std::vector<CachedMatch> matches_;  // kept for its memory
  std::vector<AcrossRings> across_;   // the same
};

}  // namespace revisit_slam
