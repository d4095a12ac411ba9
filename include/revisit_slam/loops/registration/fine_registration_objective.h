// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/normal_equations.h"
#include "revisit_slam/icp/robust_kernel.h"
#include "revisit_slam/loops/registration/fine_registration_surfels.h"

namespace revisit_slam {

/// What the fine registration of a submap minimises at one level: point to plane, where either
/// surfel has a normal, else point to point, with the kernel of Geman and McClure. To change it,
/// change these two files and, for a new kernel or residual, those of icp/ (see
/// odometry/scan_objective.h).
class FineRegistrationObjective {
 public:
  /// `distance`: m, reach of the correspondences of the level.
  explicit FineRegistrationObjective(double distance);

  /// Adds one correspondence under `T`, T_target_source. The plane is that of the target, else that
  /// of the source.
  void add(const Surfel& source, const Surfel& target, const SurfelPose& T,
           NormalEquations& equations) const;

 private:
  GemanMcClure kernel_;
};

/// Gauss-Newton step, damped so that directions without constraints stay where they are.
Tangent dampedStep(const NormalEquations& equations);

}  // namespace revisit_slam
