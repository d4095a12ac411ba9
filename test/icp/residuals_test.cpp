// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/residuals.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// A source point, its target point and the normal of the plane there, under a pose.
struct Correspondence {
  Pose T;
  Eigen::Vector3d p, q, normal;

  /// (T p - q) after the perturbation d, in the source frame before it.
  Eigen::Vector3d residual(const Tangent& d) const {
    return T.rotationMatrix().transpose() * (boxplus(T, d) * p - q);
  }
  PointToPoint pointToPoint() const { return {p, residual(Tangent::Zero())}; }
  PointToPlane pointToPlane() const {
    const Eigen::Vector3d n = T.rotationMatrix().transpose() * normal;
    return {p, n, n.dot(residual(Tangent::Zero()))};
  }
};

Correspondence correspondence(unsigned seed) {
  RandomNumbers random(seed);
  return {random.pose(5.0), random.inCube(30.0), random.inCube(30.0), random.direction()};
}

constexpr double kStep = 1e-6;

TEST(Residuals, JacobiansAreNumericDerivativesForRightPerturbations) {
  for (unsigned seed = 1; seed < 10; ++seed) {
    const Correspondence c = correspondence(seed);
    const PointToPlane plane = c.pointToPlane();
    for (int axis = 0; axis < 6; ++axis) {
      const Tangent d = kStep * Tangent::Unit(axis);
      const Eigen::Vector3d numeric = (c.residual(d) - c.residual(-d)) / (2.0 * kStep);
      EXPECT_LT((c.pointToPoint().jacobian().col(axis) - numeric).norm(), 1e-6) << axis;
      EXPECT_NEAR(plane.jacobian()[axis], plane.n.dot(numeric), 1e-6) << axis;
    }
  }
}

TEST(Residuals, SquaresDoNotDependOnTheFrame) {
  const Correspondence c = correspondence(20);
  const Eigen::Vector3d r_target = c.T * c.p - c.q;
  EXPECT_NEAR(c.pointToPoint().squared(), r_target.squaredNorm(), 1e-9);
  EXPECT_NEAR(c.pointToPlane().squared(), std::pow(c.normal.dot(r_target), 2), 1e-9);
}

}  // namespace
}  // namespace revisit_slam
