// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "revisit_slam/icp/local_voxel_map.h"
#include "revisit_slam/icp/normal_equations.h"
#include "revisit_slam/icp/ring_spacing.h"
#include "revisit_slam/icp/robust_kernel.h"
#include "revisit_slam/odometry/odometry_config.h"

namespace revisit_slam {

/// What the registration of a scan minimises (paper Eq. 1; KISS-ICP Sec. III-C), of residuals
/// r_i = R^T (T p_i - q_i) to map points nearer than 3 sigma, with T = T_odom_base:
///
///   sum_i a_i w(s_i) s_i,  s_i = |r_i|^2 - b_i (u_i^T r_i)^2,
///
/// and where the map around q_i is planar with the normal n_i, instead
///
///   sum_i w(e_i^2) (e_i^2 + c |r_i|^2),  e_i = n_i^T r_i,
///
/// where w is the weight of Geman and McClure with k^2 = sigma, recomputed in each iteration. a_i
/// is small where the map points around are few or linear: the rings that a sensor draws on the
/// ground and on walls move along with it; taken as points they hold the estimate back and turn it
/// (docs/odometry.md). u_i is the direction across the rings of the sensor, b_i how little is known
/// between them (icp/ring_spacing.h): what is no plane, such as a tree, matches the same ring of
/// the scan before, whose height is that of the sensor then, and the pose would be turned up or
/// down. With `planes` off a_i is 1, b_i 0 and all residuals are point to point.
///
/// To change the objective of the odometry, change this file; for a new kernel icp/robust_kernel.h
/// as well, for a new residual icp/residuals.h and icp/normal_equations.h, for a new parameter
/// odometry_config.h. Registration stays as it is. The objective of submaps,
/// loops/registration/fine_registration_objective.h, is made of the same parts.
class ScanObjective {
 public:
  /// `sigma`: m, the scale of the annealed kernel. `ring_factor`: of the weights of what moves
  /// along with the sensor (RingLimit).
  ScanObjective(const RegistrationConfig& config, double sigma, double ring_factor = 1.0)
      : config_(config),
        sigma_(sigma),
        ring_factor_(ring_factor),
        kernel_(GemanMcClure::ofSquaredScale(sigma)) {}

  /// m: points without a map point nearer than this are not matched.
  static double maxDistance(double sigma) { return 3.0 * sigma; }
  double maxDistance() const { return maxDistance(sigma_); }

  /// Adds the match of a point with a neighbour. `R`: R_odom_base.
  void add(const PointToPoint& match, const LocalShape& shape, const AcrossRings& across,
           const Eigen::Matrix3d& R, NormalEquations& equations) const {
    if (config_.planes && shape.kind == ShapeKind::planar) {
      const Eigen::Vector3d n = R.transpose() * shape.normal.cast<double>();
      const PointToPlane plane{match.p, n, n.dot(match.r)};
      const double weight = kernel_.weight(plane.squared());
      countMatch(plane.squared(), shape, equations);
      equations.add(plane, weight);
      const double within = ring_factor_ * config_.within_plane_weight * weight;
      equations.add(match, within);
      equations.countRing(within);
    } else {
      const Eigen::Vector3d& u = across.direction_base;
      const PointToPlane between{match.p, u, u.dot(match.r)};
      const double unknown = config_.planes ? across.unknown : 0.0;
      const double squared = match.squared() - unknown * between.squared();
      const double weight = shapeWeight(shape) * kernel_.weight(squared);
      countMatch(match.squared(), shape, equations);
      equations.add(match, weight);
      if (config_.planes && shape.kind == ShapeKind::sparse) equations.countRing(weight);
      if (unknown > 0.0) equations.add(between, -unknown * weight);
    }
  }

 private:
  static constexpr float kLevel = 0.8f;  // z of a normal: slopes of up to 37 degrees

  void countMatch(double squared, const LocalShape& shape, NormalEquations& equations) const {
    equations.countMatch(squared);
    if (squared <= config_.final_sigma * config_.final_sigma)
      equations.countExplained(isAlike(shape));
  }

  /// Level ground, and the rings that the sensor draws on it.
  bool isAlike(const LocalShape& shape) const {
    if (!config_.planes) return false;
    if (shape.kind == ShapeKind::planar) return std::abs(shape.normal.z()) > kLevel;
    return shape.kind == ShapeKind::sparse;
  }

  /// a_i. The denser the map, the less the nearest point depends on where rays fell.
  double shapeWeight(const LocalShape& shape) const {
    if (!config_.planes) return 1.0;
    if (shape.kind == ShapeKind::sparse) return ring_factor_ * config_.sparse_weight;
    return std::min(1.0, static_cast<double>(shape.points) / config_.scattered_points);
  }

  const RegistrationConfig& config_;
  double sigma_;
  double ring_factor_;
  GemanMcClure kernel_;
};

}  // namespace revisit_slam
