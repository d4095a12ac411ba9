// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "revisit_slam/pose_graph/ceres_manifold.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// A pose as the solver stores it: qx qy qz qw, tx ty tz.
using PoseBlock = std::array<double, 7>;

PoseBlock blockOf(const Pose& T);
Pose poseOf(const double* block);

/// Right perturbations of a pose block, Plus(T, d) = T * Exp(d) with d = [translation; rotation].
struct PoseChart {
  static constexpr int kAmbient = 7;
  static constexpr int kTangent = 6;

  static bool plus(const double* block, const double* d, double* moved);
  static bool minus(const double* moved, const double* block, double* d);

  /// 7x6, d Plus(T, d) / d d at d = 0.
  static bool plusJacobian(const double* block, double* J);
  /// 6x7, d Minus(y, T) / d y at y = T.
  static bool minusJacobian(const double* block, double* J);
};

using PoseManifold = CeresManifold<PoseChart>;

}  // namespace revisit_slam
