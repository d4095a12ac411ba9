// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/factor_shape.h"

namespace revisit_slam {

/// A measurement of where up is, by the accelerometer of a base. Its axes are off by a constant
/// rotation R_base_imu, which two nodes stand for: the base at the session's first scan, and the
/// accelerometer there. With the orientations R_0, R_u, R_l, R_s of these two, of a frame that
/// is level and of the scan, the residual is
///
///   e = up - v,  v = R_base_imu^T w,  w = R_s^T R_l e_z,  R_base_imu = R_0^T R_u,
///
/// with, for right perturbations T * Exp([translation; rotation]), no derivative by a translation,
/// and by the rotations
///
///   de/dd_0 = R_base_imu^T skew(w),  de/dd_u = -skew(v),
///   de/dd_l = R_base_imu^T R_s^T R_l skew(e_z),  de/dd_s = -R_base_imu^T skew(w).
struct GravityFactor {
  using Shape = FactorShape<3, 4>;

  Shape::Nodes nodes;                                         ///< first, imu, level, scan
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();              ///< unit vector, as measured
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< 1/rad^2

  Eigen::Vector3d error(const Shape::Poses& T_map_node) const;
  Shape::Linearization linearized(const Shape::Poses& T_map_node, const Eigen::Matrix3d& U) const;
  bool isFinite() const;
};

}  // namespace revisit_slam
