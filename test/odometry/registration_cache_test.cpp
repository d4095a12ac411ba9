// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "revisit_slam/odometry/registration.h"
#include "support/room_map.h"

namespace revisit_slam {
namespace {

/// The same method without a cache of correspondences, written plainly.
RegistrationResult alignPlainly(const Points& points, const LocalVoxelMap& map, Pose T,
                                double sigma, const RegistrationConfig& config) {
  RegistrationResult result;
  double step_length = 1.0;
  while (result.iterations < config.max_iterations) {
    const bool is_final = sigma <= config.final_sigma;
    if (is_final && step_length < config.convergence) break;
    if (!is_final && step_length < 10.0 * config.convergence) {
      sigma = std::max(config.final_sigma, 0.5 * sigma);
      step_length = 1.0;
      continue;
    }
    Matrix6 H = Matrix6::Zero();
    Tangent g = Tangent::Zero();
    result.correspondences = 0;
    for (const Eigen::Vector3f& point : points) {
      const Eigen::Vector3d p = point.cast<double>(), p_odom = T * p;
      Neighbour neighbour;
      if (!map.nearest(p_odom, 3.0 * sigma, neighbour)) continue;
      ++result.correspondences;
      const Eigen::Vector3d r = T.rotation.conjugate() * (p_odom - neighbour.point_odom);
      Eigen::Matrix<double, 3, 6> J;
      J << Eigen::Matrix3d::Identity(), -skew(p);
      Eigen::Matrix3d M = Eigen::Matrix3d::Identity();  // the cost of a point is r^T M r
      double squared = r.squaredNorm();
      const LocalShape& shape = neighbour.shape;
      if (config.planes && shape.kind == ShapeKind::sparse) M *= config.sparse_weight;
      if (config.planes && shape.kind == ShapeKind::scattered)
        M *= std::min(1.0, shape.points / config.scattered_points);
      if (config.planes && shape.kind == ShapeKind::planar) {
        const Eigen::Vector3d n = T.rotation.conjugate() * shape.normal.cast<double>();
        M = n * n.transpose() + config.within_plane_weight * Eigen::Matrix3d::Identity();
        squared = std::pow(n.dot(r), 2);
      }
      const double weight = std::pow(sigma / (sigma + squared), 2);
      H += weight * J.transpose() * M * J;
      g += weight * J.transpose() * M * r;
    }
    const Tangent step = H.ldlt().solve(-g);
    T = T * exp(step);
    step_length = step.norm();
    ++result.iterations;
  }
  result.T_odom_base = T;
  return result;
}

TEST(Registration, EqualsThePlainMethodWithoutItsCache) {
  const LocalVoxelMap map = mapOfRoom(0.02);
  RandomNumbers random(4);
  RegistrationConfig planes, points;
  points.planes = false;
  Registration with_planes(planes), with_points(points);  // nothing stays from the run before
  for (const double sigma : {0.1, 0.3, 2.0})
    for (int i = 0; i < 4; ++i) {
      const Pose truth = exp(random.tangent(1.0, 0.3));
      const Points seen = SyntheticRoom().sample(truth.translation, 1500, 0.02, random);
      const Pose initial = boxplus(truth, random.tangent(0.4, 0.04));
      const Points source = seenFrom(truth, seen);
      for (const auto& [registration, config] :
           {std::pair{&with_planes, planes}, {&with_points, points}}) {
        const auto result = registration->align(source, {}, map, initial, sigma);
        const auto plain = alignPlainly(source, map, initial, sigma, config);
        EXPECT_EQ(result.iterations, plain.iterations);
        EXPECT_EQ(result.correspondences, plain.correspondences);
        EXPECT_LT(distanceBetween(result.T_odom_base, plain.T_odom_base), 1e-9);
      }
    }
}

}  // namespace
}  // namespace revisit_slam
