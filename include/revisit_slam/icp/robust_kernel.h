// SPDX-License-Identifier: MIT
#pragma once

namespace revisit_slam {

/// A robust kernel is a function rho of a squared residual s, with rho(s) ~ s for small s, that
/// limits what wrong matches contribute. Its derivative rho' is the weight of the match in the
/// normal equations (iteratively reweighted least squares).
///
/// Geman and McClure:
///
///   rho(s) = s k^2 / (k^2 + s),  w(s) = rho'(s) = (k^2 / (k^2 + s))^2,
///
/// with the scale k in the unit of the residual. KISS-ICP writes w(s) = (sigma / (sigma + s))^2,
/// which is k = sqrt(sigma). The pose graph has the same function for Ceres
/// (pose_graph/robust_kernel.h).
class GemanMcClure {
 public:
  static GemanMcClure ofScale(double k) { return GemanMcClure(k * k); }
  static GemanMcClure ofSquaredScale(double k_squared) { return GemanMcClure(k_squared); }

  double rho(double squared_residual) const {
    return squared_residual * (k_squared_ / (k_squared_ + squared_residual));
  }

  double weight(double squared_residual) const {
    const double root = k_squared_ / (k_squared_ + squared_residual);
    return root * root;
  }

 private:
  explicit GemanMcClure(double k_squared) : k_squared_(k_squared) {}

  double k_squared_;
};

/// Truncated quadratic: rho(s) = min(s, tau^2), with tau in the unit of the residual. The objective
/// that is sampled for the information has this one (paper Sec. III-B), in the precision of points.
class TruncatedQuadratic {
 public:
  explicit TruncatedQuadratic(double tau) : tau_squared_(static_cast<float>(tau * tau)) {}

  float rho(float squared_residual) const {
    return squared_residual < tau_squared_ ? squared_residual : tau_squared_;
  }

 private:
  float tau_squared_;
};

}  // namespace revisit_slam
