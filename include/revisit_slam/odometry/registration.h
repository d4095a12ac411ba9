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

/// The neighbour found for a point, and where the point was then: while the point has moved less
/// than its neighbour's rivals are farther, the neighbour is still the nearest.
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
/// The robust kernel is annealed: once ICP has converged it goes on with half of sigma, and so on
/// down to final_sigma. At first sigma has to be as large as the prediction may be wrong, which is
/// much where the steps of a person shake the sensor, and what is new to the map then matches
/// whatever is near. Where too few matches are left at a smaller sigma, the pose of the larger one
/// is the result.
///
/// a_i is small where the map points around are few or linear. The rings that a sensor draws on the
/// ground and on walls move along with it; taken as points they hold the estimate back and turn it
/// (docs/odometry.md). With `planes` off a_i is 1 and all residuals are point to point.
///
/// Points may come with sweep fractions (see PreprocessedScan). They were deskewed with the
/// predicted motion, which missed d = Log(T_odom_predicted^-1 T_odom_base). A point with the sweep
/// fraction s is therefore taken as at T_odom_base Exp(-s c) p_i with the deskew correction
///
///   c = deskew_gain (H + deskew_damping I)^-1 H d,  H the Gauss-Newton matrix of the sum,
///
/// so that directions which the matches do not constrain stay as predicted, and
/// prediction_weight |d|^2 is added.
class Registration {
 public:
  explicit Registration(const RegistrationConfig& config) : config_(config) {}

  /// Points with no map point nearer than this are left out, m.
  static double maxCorrespondenceDistance(double sigma) { return 3.0 * sigma; }

  /// `sweep_fractions`: one for each point, or none; T_odom_predicted is then the first guess
  /// alone. `sigma` in metres. Runs in the current TBB arena; the same bits for any number of
  /// threads.
  RegistrationResult align(const Points& points_base, const std::vector<float>& sweep_fractions,
                           const LocalVoxelMap& map, const Pose& T_odom_predicted, double sigma);

 private:
  RegistrationConfig config_;
  std::vector<CachedMatch> matches_;  // kept for its memory
};

}  // namespace revisit_slam
