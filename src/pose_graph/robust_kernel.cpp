// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/robust_kernel.h"

#include <stdexcept>

namespace revisit_slam {

void GemanMcClureLoss::Evaluate(double squared_norm, double rho[3]) const {
  const double inverse = 1.0 / (scale2_ + squared_norm);
  const double ratio = scale2_ * inverse;
  rho[0] = squared_norm * ratio;
  rho[1] = ratio * ratio;
  rho[2] = -2.0 * rho[1] * inverse;
}

std::unique_ptr<ceres::LossFunction> makeLoss(const RobustKernel& kernel) {
  if (kernel.name == "none") return nullptr;
  if (kernel.name == "huber") return std::make_unique<ceres::HuberLoss>(kernel.scale);
  if (kernel.name == "cauchy") return std::make_unique<ceres::CauchyLoss>(kernel.scale);
  if (kernel.name == "geman_mcclure") return std::make_unique<GemanMcClureLoss>(kernel.scale);
  throw std::invalid_argument("there is no robust kernel '" + kernel.name + "'");
}

}  // namespace revisit_slam
