// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/sized_cost_function.h>

#include "revisit_slam/pose_graph/pose_block.h"
#include "revisit_slam/types/constraint.h"

namespace revisit_slam {

/// Residual of a constraint Z = T_from_to between the poses T_i = T_map_from and T_j = T_map_to:
///
///   e = Log(Z^-1 T_i^-1 T_j),  [translation; rotation], metres and radians, in the frame of j.
Tangent relativePoseError(const Pose& T_from_to, const Pose& T_map_from, const Pose& T_map_to);

/// The squared Mahalanobis length e^T information e of that residual.
double chi2(const Constraint& constraint, const Pose& T_map_from, const Pose& T_map_to);

/// The Ceres term U e with U^T U = information, over two pose blocks i and j. For right
/// perturbations T * Exp(d)
///
///   de/dd_j = Jr^-1(e),  de/dd_i = -Jr^-1(e) Ad(T_j^-1 T_i),
///
/// which the Jacobians of the manifold's Minus turn into derivatives by the seven block entries.
class RelativePoseCost : public ceres::SizedCostFunction<6, 7, 7> {
 public:
  explicit RelativePoseCost(const Constraint& constraint);

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override;

 private:
  Pose T_to_from_;  ///< Z^-1
  Matrix6 root_;    ///< U
};

}  // namespace revisit_slam
