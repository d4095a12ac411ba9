// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/loss_function.h>

#include <memory>
#include <string>

namespace revisit_slam {

enum class KernelType { none, huber, cauchy, geman_mcclure };

/// @throws std::invalid_argument for an unknown name.
KernelType kernelTypeOf(const std::string& name);

/// A function rho of s = chi2 of a factor, with rho(s) ~ s for s << scale^2:
///
///   none           s
///   huber          2 k sqrt(s) - k^2 beyond s = k^2
///   cauchy         k^2 log(1 + s / k^2)
///   geman_mcclure  s k^2 / (k^2 + s)
struct RobustKernel {
  KernelType type = KernelType::none;
  double scale = 1.0;  ///< k

  /// Whether the influence sqrt(s) rho'(s) falls again far away, so that a factor which is right,
  /// but starts far from the solution, has hardly any.
  bool isRedescending() const {
    return type == KernelType::cauchy || type == KernelType::geman_mcclure;
  }
};

/// rho(s) = s k^2 / (k^2 + s) stays below k^2: a loop against all others loses its influence.
/// The weight rho' = (k^2 / (k^2 + s))^2 is that of dynamic covariance scaling, but for a factor of
/// 4 far away.
class GemanMcClureLoss : public ceres::LossFunction {
 public:
  explicit GemanMcClureLoss(double scale) : scale2_(scale * scale) {}
  void Evaluate(double squared_norm, double rho[3]) const override;

 private:
  double scale2_;  ///< k^2
};

/// Null for none.
std::unique_ptr<ceres::LossFunction> makeLoss(const RobustKernel& kernel);

}  // namespace revisit_slam
