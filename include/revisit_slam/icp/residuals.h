// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// Residuals of a source point p matched to a target point q under T = T_target_source = (R, t).
/// They are expressed in the source frame, where their Jacobians for right perturbations T * Exp(d)
/// depend on p alone (to first order).

/// r = R^T (T p - q).
struct PointToPoint {
  Eigen::Vector3d p;
  Eigen::Vector3d r;

  double squared() const { return r.squaredNorm(); }

  Eigen::Matrix<double, 3, 6> jacobian() const {
    Eigen::Matrix<double, 3, 6> J;
    J << Eigen::Matrix3d::Identity(), -skew(p);
    return J;
  }
};

/// e = n^T r, with the plane's normal n in the source frame.
struct PointToPlane {
  Eigen::Vector3d p;
  Eigen::Vector3d n;
  double e;

  double squared() const { return e * e; }

  /// A column.
  Tangent jacobian() const {
    Tangent J;
    J << n, p.cross(n);
    return J;
  }
};

}  // namespace revisit_slam
