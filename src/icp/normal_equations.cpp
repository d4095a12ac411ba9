// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/normal_equations.h"

namespace revisit_slam {

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
  point_weight_ += other.point_weight_;
  plane_weight_ += other.plane_weight_;
  ring_weight_ += other.ring_weight_;
  squares_ += other.squares_;
  wp_ += other.wp_;
  wr_ += other.wr_;
  wpxr_ += other.wpxr_;
  wpp_ += other.wpp_;
  plane_H_ += other.plane_H_;
  plane_g_ += other.plane_g_;
  matches_ += other.matches_;
  explained_ += other.explained_;
  explained_alike_ += other.explained_alike_;
  return *this;
}

Matrix6 NormalEquations::H() const {
  Matrix6 H;
  H << point_weight_ * Eigen::Matrix3d::Identity(), -skew(wp_), skew(wp_),
      wpp_.trace() * Eigen::Matrix3d::Identity() - wpp_;
  H += plane_H_;
  return H;
}

Tangent NormalEquations::g() const {
  Tangent g;
  g << wr_, wpxr_;
  g += plane_g_;
  return g;
}

}  // namespace revisit_slam
