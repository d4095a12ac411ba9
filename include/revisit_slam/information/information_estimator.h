// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/information/objective_sampling.h"
#include "revisit_slam/information/registration_problem.h"
#include "revisit_slam/types/information_estimate.h"

namespace revisit_slam {

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
