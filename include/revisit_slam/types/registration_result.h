// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

enum class RegistrationOutcome {
  converged,
  max_iterations,           ///< the pose is the last iterate
  too_few_correspondences,  ///< the pose is the initial one
  no_fit,                   ///< nor from any other guess: the pose is the initial one
  map_empty,                ///< the first scan: the pose is the initial one
};

const char* toString(RegistrationOutcome outcome);

struct RegistrationResult {
  Pose T_odom_base;
  /// What the motion since the previous scan, with which the points were deskewed, is estimated to
  /// have missed, [m; rad]; zero without sweep fractions. See `applyDeskewCorrection`.
  Tangent deskew_correction = Tangent::Zero();
  /// What the matches tell of T_odom_base, without the prediction: the inverse of a covariance of
  /// right perturbations, [m; rad] in the base frame. Zero where too little matched.
  Matrix6 information = Matrix6::Zero();
  /// Whether in every direction of translation more holds the pose than rings that move along with
  /// the sensor (RingLimit).
  bool sees_motion = false;
  RegistrationOutcome outcome = RegistrationOutcome::map_empty;
  int iterations = 0;
  std::size_t correspondences = 0;
  /// Share of the points that the map explains: with a residual of at most final_sigma, 0 … 1.
  /// Points that it explains on level ground, or on rings, fit at many places: they count a tenth.
  double explained = 0.0;
  double explained_anywhere = 0.0;  ///< the same with all points alike
  double rms_residual = 0.0;        ///< m, of the correspondences at the last iterate, |e| or |r|
};

}  // namespace revisit_slam
