// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/icp/normal_equations.h"
#include "revisit_slam/odometry/odometry_config.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Points with sweep fractions (see PreprocessedScan) were deskewed with the predicted motion,
/// which missed d = Log(T_odom_predicted^-1 T_odom_base). While a scan is registered a point with
/// the sweep fraction s is therefore taken as at T_odom_base Exp(-s c) p with the deskew correction
///
///   c = deskew_gain (H + deskew_damping I)^-1 H d,  H the Gauss-Newton matrix of the matches,
///
/// so that directions which the matches do not constrain stay as predicted (docs/odometry.md).

/// The base during the sweep, to first order in the sweep fraction: the correction is small.
class SweepPose {
 public:
  SweepPose(const Pose& T_odom_base, const Tangent& correction);

  /// At the end of the scan.
  const Eigen::Matrix3d& R_odom_base() const { return R_; }

  Eigen::Vector3d toOdom(const Eigen::Vector3d& p_base, double sweep_fraction) const {
    return R_ * p_base + t_ + sweep_fraction * (turned_ * p_base + moved_);
  }

 private:
  Eigen::Matrix3d R_, turned_;
  Eigen::Vector3d t_, moved_;
};

/// A Gauss-Newton step of the pose, and how the deskew correction follows the deviation d.
struct DeskewedStep {
  Tangent step;
  Matrix6 correction_per_deviation;
};

/// d' prediction_weight d is added to the objective. `deviation`: d before the step.
DeskewedStep deskewedStep(const NormalEquations& equations, const Tangent& deviation,
                          const Matrix6& prediction_weight, double mean_sweep_fraction,
                          const RegistrationConfig& config);

/// Deskews points anew where the motion that they were deskewed with missed `correction` ([m; rad],
/// small, in the base frame at the stamp) of the motion since the previous scan.
void applyDeskewCorrection(Points& points_base, const std::vector<float>& sweep_fractions,
                           const Tangent& correction);

}  // namespace revisit_slam
