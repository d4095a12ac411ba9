// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "revisit_slam/odometry/odometry_config.h"

namespace revisit_slam {

/// The schedule of the annealed robust kernel: each time ICP has converged, sigma is halved, down
/// to final_sigma. At first sigma has to be as large as the prediction may be wrong, which is much
/// where the steps of a person shake the sensor, and what is new to the map then matches whatever
/// is near.
class AnnealedSigma {
 public:
  /// `initial`: m. Where it is not larger than final_sigma it stays.
  AnnealedSigma(double initial, const RegistrationConfig& config)
      : sigma_(initial), final_sigma_(config.final_sigma), convergence_(config.convergence) {}

  double value() const { return sigma_; }

  /// Whether ICP has converged with a larger sigma.
  bool isReduced() const { return is_reduced_; }

  /// Takes note of a step of ICP. @return whether it has converged with the final sigma.
  bool hasConverged(double step_length) {
    const bool is_final = sigma_ <= final_sigma_;
    if (step_length >= (is_final ? 1.0 : kCoarseConvergence) * convergence_) return false;
    if (is_final) return true;
    sigma_ = std::max(final_sigma_, 0.5 * sigma_);
    is_reduced_ = true;
    return false;
  }

 private:
  /// Before the final sigma a step that is so many times longer is short enough.
  static constexpr double kCoarseConvergence = 10.0;

  double sigma_;
  double final_sigma_;
  double convergence_;
  bool is_reduced_ = false;
};

}  // namespace revisit_slam
