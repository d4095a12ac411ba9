// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/robust_kernel.h"

#include <stdexcept>

namespace revisit_slam {

KernelType kernelTypeOf(const std::string& name) {
  if (name == "none") return KernelType::none;
  if (name == "huber") return KernelType::huber;
  if (name == "cauchy") return KernelType::cauchy;
  if (name == "geman_mcclure") return KernelType::geman_mcclure;
  throw std::invalid_argument("there is no robust kernel '" + name + "'");
}

void GemanMcClureLoss::Evaluate(double squared_norm, double rho[3]) const {
  const double inverse = 1.0 / (scale2_ + squared_norm);
  const double ratio = scale2_ * inverse;
  rho[0] = squared_norm * ratio;
  rho[1] = ratio * ratio;
  rho[2] = -2.0 * rho[1] * inverse;
}

std::unique_ptr<ceres::LossFunction> makeLoss(const RobustKernel& kernel) {
  switch (kernel.type) {
    case KernelType::none:
      break;
    case KernelType::huber:
      return std::make_unique<ceres::HuberLoss>(kernel.scale);
    case KernelType::cauchy:
      return std::make_unique<ceres::CauchyLoss>(kernel.scale);
    case KernelType::geman_mcclure:
      return std::make_unique<GemanMcClureLoss>(kernel.scale);
  }
  return nullptr;
}

}  // namespace revisit_slam
