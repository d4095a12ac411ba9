// SPDX-License-Identifier: MIT
#include "revisit_slam/loops/registration/fine_registration_equations.h"

#include <Eigen/Cholesky>

namespace revisit_slam {
namespace {

/// Share of the weights added to the diagonal; rotations act at the distance of a lever, metres.
constexpr double kDamping = 1e-4;
constexpr double kLever = 10.0;

}  // namespace

PlaneEquations& PlaneEquations::operator+=(const PlaneEquations& other) {
  H += other.H;
  g += other.g;
  weights += other.weights;
  squares += other.squares;
  count += other.count;
  return *this;
}

Tangent PlaneEquations::step() const {
  const double damping = kDamping * weights;
  Matrix6 damped = H;
  damped.diagonal().head<3>().array() += damping;
  damped.diagonal().tail<3>().array() += damping * kLever * kLever;
  return damped.ldlt().solve(-g);
}

}  // namespace revisit_slam
