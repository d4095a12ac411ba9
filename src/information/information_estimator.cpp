// SPDX-License-Identifier: MIT
#include "revisit_slam/information/information_estimator.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace revisit_slam {
namespace {

template <typename Matrix>
Matrix clampEigenvalues(const Matrix& hessian, double smallest, double smallest_share) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(hessian);
  const double floor = std::max(smallest, smallest_share * solver.eigenvalues().maxCoeff());
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(floor).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// H+ (paper Sec. III-B): blocks of translation and rotation apart, as their units differ; of the
/// full matrix no share.
Matrix6 positive(const Matrix6& hessian, const InformationConfig& config) {
  if (config.full) return clampEigenvalues(hessian, config.min_eigenvalue, 0.0);
  Matrix6 clamped = Matrix6::Zero();
  for (const int first : {0, 3})
    clamped.block<3, 3>(first, first) =
        clampEigenvalues(Eigen::Matrix3d(hessian.block<3, 3>(first, first)), config.min_eigenvalue,
                         config.min_eigenvalue_share);
  return clamped;
}

/// Of translation (first_axis 0) or rotation (3); one unit in each, so that eigenvalues compare.
void findWeakDirections(const Matrix6& hessian, int first_axis, const InformationConfig& config,
                        std::vector<WeakDirection>& weak_directions) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      hessian.block<3, 3>(first_axis, first_axis));
  const Eigen::Vector3d& eigenvalues = solver.eigenvalues();
  const double weak_below = std::max(config.min_eigenvalue, config.weak_ratio * eigenvalues[2]);
  for (int i = 0; i < 3 && eigenvalues[i] < weak_below; ++i) {
    WeakDirection weak{Tangent::Zero(), eigenvalues[i]};
    weak.direction.segment<3>(first_axis) = solver.eigenvectors().col(i);
    weak_directions.push_back(weak);
  }
}

}  // namespace

InformationEstimator::InformationEstimator(const InformationConfig& config)
    : config_(config), designs_(makeDesigns(config)) {
  for (std::size_t index = 0; index < designs_.size(); ++index)
    samplings_.emplace_back(designs_[index], index);
}

RegistrationProblem InformationEstimator::gather(const Points& points_base,
                                                 const LocalVoxelMap& map, const Pose& T_odom_base,
                                                 double tau) const {
  return gatherProblem(points_base, map, T_odom_base, tau,
                       static_cast<std::size_t>(config_.max_points), designs_);
}

InformationEstimate InformationEstimator::estimate(const RegistrationProblem& problem) const {
  InformationEstimate estimate;
  if (problem.points_base.empty()) return estimate;
  Matrix6 hessian = Matrix6::Zero();
  for (std::size_t index = 0; index < designs_.size(); ++index) {
    const Eigen::VectorXd chi = problem.scale * samplings_[index].evaluate(problem);
    const Eigen::Index samples = chi.size() - 1;
    const double chi_at_pose = chi[samples];
    const QuadraticFit fit = designs_[index].fit(chi.head(samples).array() - chi_at_pose);
    const int first = designs_[index].firstAxis();
    const Eigen::Index axes = fit.gradient.size();
    estimate.gradient.segment(first, axes) = fit.gradient;
    hessian.block(first, first, axes, axes) = fit.hessian;
    estimate.mean_squared_residual =
        chi_at_pose / (problem.scale * static_cast<double>(problem.points_base.size()));
  }
  estimate.information = positive(hessian, config_);
  for (const int first_axis : {0, 3})
    findWeakDirections(hessian, first_axis, config_, estimate.weak_directions);
  return estimate;
}

}  // namespace revisit_slam
