// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/problem.h>
#include <ceres/version.h>

#if CERES_VERSION_MAJOR < 2 || (CERES_VERSION_MAJOR == 2 && CERES_VERSION_MINOR < 1)
#define REVISIT_SLAM_CERES_WITHOUT_MANIFOLD
#include <ceres/local_parameterization.h>
#else
#include <ceres/manifold.h>
#endif

namespace revisit_slam {

/// What Ceres up to 2.0 calls a LocalParameterization and since 2.1 a Manifold. `Chart` has the
/// sizes kAmbient and kTangent and the static functions plus(x, delta, x_plus_delta),
/// plusJacobian(x, J), minus(y, x, delta) and minusJacobian(x, J), matrices in row-major order.
#ifdef REVISIT_SLAM_CERES_WITHOUT_MANIFOLD
template <typename Chart>
class CeresManifold : public ceres::LocalParameterization {
 public:
  int GlobalSize() const override { return Chart::kAmbient; }
  int LocalSize() const override { return Chart::kTangent; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    return Chart::plus(x, delta, x_plus_delta);
  }
  bool ComputeJacobian(const double* x, double* J) const override {
    return Chart::plusJacobian(x, J);
  }
};
#else
template <typename Chart>
class CeresManifold : public ceres::Manifold {
 public:
  int AmbientSize() const override { return Chart::kAmbient; }
  int TangentSize() const override { return Chart::kTangent; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    return Chart::plus(x, delta, x_plus_delta);
  }
  bool PlusJacobian(const double* x, double* J) const override { return Chart::plusJacobian(x, J); }
  bool Minus(const double* y, const double* x, double* delta) const override {
    return Chart::minus(y, x, delta);
  }
  bool MinusJacobian(const double* x, double* J) const override {
    return Chart::minusJacobian(x, J);
  }
};
#endif

/// Lets the problem, which becomes the owner, change the block along the manifold only.
template <typename Chart>
void setManifold(ceres::Problem& problem, double* block, CeresManifold<Chart>* manifold) {
#ifdef REVISIT_SLAM_CERES_WITHOUT_MANIFOLD
  problem.SetParameterization(block, manifold);
#else
  problem.SetManifold(block, manifold);
#endif
}

}  // namespace revisit_slam
