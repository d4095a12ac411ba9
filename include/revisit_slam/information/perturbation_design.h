// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "revisit_slam/information/information_config.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Gradient and Hessian of the objective over some axes of the tangent space.
struct QuadraticFit {
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

/// Perturbations d_m along some axes of the tangent space and the regression of the objective's
/// changes on them (paper Eq. 5): b_m = d_m^T g + 1/2 d_m^T H d_m. The samples come in pairs +d,
/// -d, which keeps the estimates of g and H from disturbing each other. They are drawn once, from a
/// fixed seed, and so is the pseudo-inverse of the design matrix.
class PerturbationDesign {
 public:
  /// Perturbs the axes [first_axis, first_axis + axes) of [translation; rotation], each uniformly
  /// in +-range of that axis. `samples` is rounded up to an even number.
  PerturbationDesign(int first_axis, int axes, int samples, const InformationConfig& config);

  int firstAxis() const { return first_axis_; }
  const std::vector<Tangent>& samples() const { return samples_; }

  /// Bounds of the samples along or about each axis, metres and radians.
  double translationRange() const { return translation_range_; }
  double rotationRange() const { return rotation_range_; }
  /// Longest translation (m) and rotation vector (rad) of a sample.
  double longestTranslation() const { return longest_translation_; }
  double longestRotation() const { return longest_rotation_; }

  /// `changes`: chi(T * Exp(d_m)) - chi(T) of each sample.
  QuadraticFit fit(const Eigen::VectorXd& changes) const;

 private:
  int first_axis_, axes_;
  double translation_range_, rotation_range_;
  double longest_translation_ = 0.0, longest_rotation_ = 0.0;
  std::vector<Tangent> samples_;
  Eigen::MatrixXd pseudo_inverse_;
};

/// The paper's two designs (translation, rotation), or one over all six axes.
std::vector<PerturbationDesign> makeDesigns(const InformationConfig& config);

}  // namespace revisit_slam
