// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "revisit_slam/icp/residuals.h"

namespace revisit_slam {

/// Gauss-Newton normal equations H d = -g of weighted residuals: H = sum w J^T J, g = sum w J^T r.
/// The order of the calls determines the last bits; chunks of matches are summed apart and then in
/// order.
class NormalEquations {
 public:
  void add(const PointToPlane& residual, double weight) {
    const Tangent J = residual.jacobian();
    const Tangent weighted = weight * J;
    plane_weight_ += weight;
    plane_H_.noalias() += weighted * J.transpose();
    plane_g_ += residual.e * weighted;
  }

  /// Only the sums that the blocks of H and g consist of: J^T J is [I, -skew(p); skew(p), |p|^2 I -
  /// p p^T].
  void add(const PointToPoint& residual, double weight) {
    const Eigen::Vector3d &p = residual.p, &r = residual.r;
    point_weight_ += weight;
    wp_ += weight * p;
    wr_ += weight * r;
    wpxr_ += weight * p.cross(r);
    wpp_ += (weight * p) * p.transpose();
  }

  /// Once for every match, however many residuals it adds. `squared`: its unweighted residual, m^2.
  void countMatch(double squared) {
    ++matches_;
    squares_ += squared;
  }

  /// A match whose residual is one of noise and sampling, not of another surface. `is_alike`: that
  /// of a point on what is alike at many places.
  void countExplained(bool is_alike) {
    ++explained_;
    if (is_alike) ++explained_alike_;
  }

  /// Of a point-to-point residual whose weight was added: what it compares moves along with the
  /// sensor, as a ring and the distance within a plane do.
  void countRing(double weight) { ring_weight_ += weight; }

  NormalEquations& operator+=(const NormalEquations& other);

  Matrix6 H() const;
  Tangent g() const;

  double weight() const { return point_weight_ + plane_weight_; }
  /// What rings add to each direction of translation in H.
  double ringWeight() const { return ring_weight_; }
  std::size_t matches() const { return matches_; }
  std::size_t explained() const { return explained_; }
  /// Of these, on what is alike at many places.
  std::size_t explainedAlike() const { return explained_alike_; }
  /// m, of the unweighted residuals of the matches.
  double rms() const { return std::sqrt(squares_ / static_cast<double>(matches_)); }

 private:
  double point_weight_ = 0.0, plane_weight_ = 0.0, ring_weight_ = 0.0, squares_ = 0.0;
  Eigen::Vector3d wp_ = Eigen::Vector3d::Zero(), wr_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d wpxr_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d wpp_ = Eigen::Matrix3d::Zero();
  Matrix6 plane_H_ = Matrix6::Zero();
  Tangent plane_g_ = Tangent::Zero();
  std::size_t matches_ = 0, explained_ = 0, explained_alike_ = 0;
};

}  // namespace revisit_slam
