// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Normal equations of robust point-to-plane registration for right perturbations T * Exp(d). With
/// T = T_target_source, a source point p, a target point q and the plane's normal m in the source
/// frame, the residual is e = m^T R^T (T p - q) and its Jacobian [m; p x m]^T.
struct PlaneEquations {
  Matrix6 H = Matrix6::Zero();
  Tangent g = Tangent::Zero();
  double weights = 0.0;
  double squares = 0.0;  // of residuals, unweighted
  std::size_t count = 0;

  void add(const Eigen::Vector3d& p, const Eigen::Vector3d& m, double e, double weight) {
    Tangent J;
    J << m, p.cross(m);
    const Tangent weighted = weight * J;
    H.noalias() += weighted * J.transpose();
    g += e * weighted;
    weights += weight;
  }

  PlaneEquations& operator+=(const PlaneEquations& other);

  /// Gauss-Newton, damped so that directions which nothing holds stay where they are.
  Tangent step() const;
};

/// Weight of Geman and McClure: 1 for small residuals, falling to nothing beyond `scale`.
inline double robustWeight(double squared_residual, double scale) {
  const double root = scale * scale / (scale * scale + squared_residual);
  return root * root;
}

}  // namespace revisit_slam
