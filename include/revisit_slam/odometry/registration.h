// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/registration_result.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/se3.h"
#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/odometry/odometry_config.h"

namespace revisit_slam {

/// The neighbour found for a point, and where the point was then: while the point has moved less than
/// its neighbour's rivals are farther, the neighbour is still the nearest.
struct CachedMatch {
  Eigen::Vector3d searched_at;
  Neighbour neighbour;
  bool valid;
};

/// ICP of a scan to the local map (paper Eq. 1-2; KISS-ICP Sec. III-C) over right perturbations
/// T * Exp(d), from correspondences nearer than 3 sigma. Minimised is
///
///   sum_i w(|r_i|^2) a_i |r_i|^2,  r_i = T_odom_base p_i - q_i,  w(s) = (sigma / (sigma + s))^2,
///
/// and where the map points around q_i lie in a plane with the normal n_i, instead
///
///   sum_i w(e_i^2) (e_i^2 + b |r_i|^2),  e_i = n_i^T r_i.
///
/// Once ICP has ended it goes on with half of sigma, and so on down to finest_sigma: sigma has to be as
/// large as the prediction may be wrong, which is much where a bearer's steps shake the sensor. What
/// is new to the map then matches whatever is near. Where too few matches are left at a finer sigma,
/// what the coarser one gave is the result.
///
/// a_i is small where the map points around are few or along one line. The rings that a sensor
/// draws on the ground and on walls move along with it; taken as points they hold the estimate back
/// and turn it (docs/odometry.md). With `planes` off a_i is 1 and all is point to point.
///
/// Points may come with lags (see PreprocessedScan). They were deskewed with the predicted motion,
/// and the more T_odom_base differs from where that leads, d = Log(T_odom_predicted^-1 T_odom_base),
/// the more the scan is bent. A point with the lag s is then taken as at T_odom_base Exp(-s b) p_i with
///
///   b = own_motion (H + held_weight I)^-1 H d,  H the Gauss-Newton matrix of the sum,
///
/// so that what the matches do not hold stays as predicted, and prediction_weight |d|^2 is added.
class Registration {
 public:
  explicit Registration(const RegistrationConfig& config) : config_(config) {}

  /// Points with no map point nearer than this are left out, m.
  static double maxCorrespondenceDistance(double sigma) { return 3.0 * sigma; }

  /// `lags`: one for each point, or none, and then T_odom_predicted is no more than where to begin.
  /// `sigma` in metres. Runs in the current TBB arena; the same bits for any number of threads.
  RegistrationResult align(const Points& points_base, const std::vector<float>& lags,
                           const LocalVoxelMap& map, const Pose& T_odom_predicted, double sigma);

 private:
  RegistrationConfig config_;
  std::vector<CachedMatch> matches_;  // kept for its memory
};

}  // namespace revisit_slam
