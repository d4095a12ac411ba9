// SPDX-License-Identifier: MIT
#include "revisit_slam/information/perturbation_design.h"

#include <Eigen/QR>
#include <algorithm>
#include <random>

namespace revisit_slam {
namespace {

/// Row of the design matrix (paper Eq. 8): d_i, then d_i^2 / 2, then d_i d_j for i < j.
Eigen::RowVectorXd designRow(const Eigen::VectorXd& d) {
  const Eigen::Index n = d.size();
  Eigen::RowVectorXd row(2 * n + n * (n - 1) / 2);
  Eigen::Index column = 0;
  for (Eigen::Index i = 0; i < n; ++i) row[column++] = d[i];
  for (Eigen::Index i = 0; i < n; ++i) row[column++] = 0.5 * d[i] * d[i];
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i + 1; j < n; ++j) row[column++] = d[i] * d[j];
  return row;
}

}  // namespace

PerturbationDesign::PerturbationDesign(int first_axis, int axes, int samples,
                                       const InformationConfig& config)
    : first_axis_(first_axis),
      axes_(axes),
      translation_range_(first_axis < 3 ? config.translation_range : 0.0),
      rotation_range_(first_axis + axes > 3 ? config.rotation_range : 0.0) {
  std::mt19937_64 generator(20260713u + static_cast<unsigned>(first_axis));
  const auto uniform = [&] {  // in [-1, 1), the same on every platform
    return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
  };
  const int pairs = (samples + 1) / 2;
  for (int pair = 0; pair < pairs; ++pair) {
    Tangent d = Tangent::Zero();
    for (int axis = first_axis; axis < first_axis + axes; ++axis)
      d[axis] = uniform() * (axis < 3 ? translation_range_ : rotation_range_);
    samples_.push_back(d);
    samples_.push_back(-d);
    longest_translation_ = std::max(longest_translation_, d.head<3>().norm());
    longest_rotation_ = std::max(longest_rotation_, d.tail<3>().norm());
  }
  Eigen::MatrixXd design(samples_.size(), designRow(samples_[0].segment(first_axis, axes)).cols());
  for (std::size_t m = 0; m < samples_.size(); ++m)
    design.row(static_cast<Eigen::Index>(m)) = designRow(samples_[m].segment(first_axis, axes));
  pseudo_inverse_ = design.completeOrthogonalDecomposition().pseudoInverse();
}

QuadraticFit PerturbationDesign::fit(const Eigen::VectorXd& changes) const {
  const Eigen::VectorXd x = pseudo_inverse_ * changes;
  QuadraticFit result{x.head(axes_), x.segment(axes_, axes_).asDiagonal()};
  Eigen::Index next = 2 * axes_;
  for (int i = 0; i < axes_; ++i)
    for (int j = i + 1; j < axes_; ++j) result.hessian(i, j) = result.hessian(j, i) = x[next++];
  return result;
}

std::vector<PerturbationDesign> makeDesigns(const InformationConfig& config) {
  if (config.full) return {{0, 6, config.samples, config}};
  const int half = config.samples / 2;
  return {{0, 3, config.samples - half, config}, {3, 3, half, config}};
}

}  // namespace revisit_slam
