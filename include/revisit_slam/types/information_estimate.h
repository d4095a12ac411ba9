// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/types/se3.h"

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

}  // namespace revisit_slam
