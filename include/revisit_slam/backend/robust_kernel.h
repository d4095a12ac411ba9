// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/loss_function.h>

#include <memory>
#include <string>

namespace revisit_slam {

/// rho(s) = s k^2 / (k^2 + s): bounded by k^2, so that a constraint that contradicts all others
/// ceases to pull. Its weight rho' = (k^2 / (k^2 + s))^2 is that of dynamic covariance scaling but
/// for a factor of 4 where it is large.
class GemanMcClureLoss : public ceres::LossFunction {
 public:
  explicit GemanMcClureLoss(double scale) : scale2_(scale * scale) {}
  void Evaluate(double squared_norm, double rho[3]) const override;

 private:
  double scale2_;  ///< k^2
};

/// The kernel of that name with scale k, rho(s) ~ s for s << k^2, where s = chi2 of a constraint.
/// Null for "none". @throws std::invalid_argument for another name.
std::unique_ptr<ceres::LossFunction> makeKernel(const std::string& name, double scale);

}  // namespace revisit_slam
