// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace revisit_slam::simulation {

/// Uniform cubic B-spline: twice continuously differentiable, near its control points rather than
/// through them. Control point k belongs to the argument k * step; beyond the ends it is constant.
template <int kDimension>
class UniformSpline {
 public:
  using Value = Eigen::Matrix<double, kDimension, 1>;

  UniformSpline() = default;
  UniformSpline(std::vector<Value> controls, double step)
      : controls_(std::move(controls)), step_(step) {}

  double end() const { return static_cast<double>(controls_.size() - 1) * step_; }
  double step() const { return step_; }
  const std::vector<Value>& controls() const { return controls_; }

  Value value(double argument) const {
    const auto [k, u] = locate(argument);
    const double v = 1.0 - u;
    return blend(k, v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                 (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, u * u * u / 6.0);
  }

  Value derivative(double argument) const {
    const auto [k, u] = locate(argument);
    const double v = 1.0 - u;
    return blend(k, -0.5 * v * v, 1.5 * u * u - 2.0 * u, -1.5 * v * v + 2.0 * v, 0.5 * u * u) /
           step_;
  }

  Value secondDerivative(double argument) const {
    const auto [k, u] = locate(argument);
    return blend(k, 1.0 - u, 3.0 * u - 2.0, 1.0 - 3.0 * u, u) / (step_ * step_);
  }

 private:
  std::pair<long, double> locate(double argument) const {
    const double x = std::clamp(argument / step_, 0.0, static_cast<double>(controls_.size() - 1));
    const double k = std::floor(x);
    return {static_cast<long>(k), x - k};
  }

  const Value& control(long k) const {
    return controls_[static_cast<std::size_t>(
        std::clamp(k, 0L, static_cast<long>(controls_.size()) - 1))];
  }

  Value blend(long k, double a, double b, double c, double d) const {
    return a * control(k - 1) + b * control(k) + c * control(k + 1) + d * control(k + 2);
  }

  std::vector<Value> controls_;
  double step_ = 1.0;
};

}  // namespace revisit_slam::simulation
