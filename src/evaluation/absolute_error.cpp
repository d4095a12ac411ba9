// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/absolute_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace revisit_slam {
namespace {

Eigen::Matrix3Xd positionsOf(const Trajectory& trajectory) {
  Eigen::Matrix3Xd positions(3, trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    positions.col(static_cast<Eigen::Index>(i)) = trajectory[i].T_world_base.translation;
  return positions;
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

AbsoluteError absoluteError(const TrajectoryMatch& match) {
  if (match.estimate.size() < 3)
    throw std::runtime_error("only " + std::to_string(match.estimate.size()) +
                             " poses lie within the time of the reference");
  const Eigen::Matrix3Xd estimate = positionsOf(match.estimate);
  const Eigen::Matrix3Xd reference = positionsOf(match.reference);
  const Eigen::Matrix4d T = Eigen::umeyama(estimate, reference, false);
  const Eigen::RowVectorXd errors =
      (((T.topLeftCorner<3, 3>() * estimate).colwise() + T.topRightCorner<3, 1>()) - reference)
          .colwise()
          .norm();
  AbsoluteError result;
  result.T_reference_estimate = Pose::fromMatrix(T);
  result.per_pose.assign(errors.data(), errors.data() + errors.size());
  result.rmse = std::sqrt(errors.squaredNorm() / static_cast<double>(errors.size()));
  result.mean = errors.mean();
  result.median = medianOf(result.per_pose);
  result.max = errors.maxCoeff();
  return result;
}

}  // namespace revisit_slam
