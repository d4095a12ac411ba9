// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/information/objective_sampling.h"
#include "revisit_slam/information/registration_problem.h"

namespace revisit_slam {

/// A direction in which the geometry hardly holds the pose.
struct WeakDirection {
  Tangent direction;  ///< unit length, [translation; rotation] in the base frame
  double eigenvalue;  ///< of the Hessian along it, before clamping
};

/// What the objective around a registration tells of it, for right perturbations T * Exp(d), hence
/// in the base frame: an odometry edge to this scan takes the information as it is.
struct InformationEstimate {
  Matrix6 information = Matrix6::Identity();  ///< Lambda_odo = H+ (paper Sec. III-B)
  Tangent gradient = Tangent::Zero();         ///< of chi; not zero where ICP stopped early
  double mean_squared_residual = 0.0;         ///< m^2, truncated, over all points
  std::vector<WeakDirection> weak_directions;
};

/// Estimates the local information matrix of point-to-point ICP by regression on samples of its
/// objective (paper Sec. III-B).
class InformationEstimator {
 public:
  explicit InformationEstimator(const InformationConfig& config);

  /// Takes the registration out of the map, which may change afterwards. `tau` in metres.
  RegistrationProblem gather(const Points& points_base, const LocalVoxelMap& map,
                             const Pose& T_odom_base, double tau) const;

  InformationEstimate estimate(const RegistrationProblem& problem) const;

  void setWeakRatio(double ratio) { config_.weak_ratio = ratio; }

 private:
  InformationConfig config_;
  std::vector<PerturbationDesign> designs_;
  std::vector<ObjectiveSampling> samplings_;
};

}  // namespace revisit_slam
