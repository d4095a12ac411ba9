// SPDX-License-Identifier: MIT
#include "revisit_slam/information/information_estimator.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <Eigen/Eigenvalues>

#include "support/information_scenes.h"

namespace revisit_slam {
namespace {

constexpr double kTau = 0.8;

InformationConfig allPoints() {
  InformationConfig config;
  config.max_points = 1000000;
  return config;
}

InformationEstimate estimate(Scene& scene, const Pose& T_true, const Pose& T,
                             const InformationConfig& config = allPoints()) {
  const InformationEstimator estimator(config);
  const LocalVoxelMap map = scene.map(T_true);
  return estimator.estimate(estimator.gather(scene.points_base, map, T, kTau));
}

InformationEstimate estimate(Scene scene) {
  return estimate(scene, {}, {});
}

bool isWeak(const InformationEstimate& estimate, const Tangent& direction) {
  double in_weak_space = 0.0;
  for (const WeakDirection& weak : estimate.weak_directions)
    in_weak_space += std::pow(weak.direction.dot(direction), 2);
  return in_weak_space > 0.95;
}

Tangent axis(int i) {
  return Tangent::Unit(i);
}

/// chi of points on a plane is 2 * sum of squared distances to it: H = 2 * sum (a a^T) with the
/// lever arms a. Against a map of points the curvature across a plane comes out smaller, as the
/// nearest point is not the foot of the perpendicular; ratios are what must hold.
TEST(InformationEstimator, OnAPlaneTheMotionWithinItIsWeak) {
  Scene scene = makePlane();
  const InformationEstimate result = estimate(scene);
  for (const int weak : {0, 1, 5}) EXPECT_TRUE(isWeak(result, axis(weak))) << weak;
  for (const int held : {2, 3, 4}) EXPECT_FALSE(isWeak(result, axis(held))) << held;
  double sum_xx = 0.0;
  for (const Eigen::Vector3f& p : scene.points_base) sum_xx += p.x() * p.x();
  const double expected_z = 2.0 * static_cast<double>(scene.points_base.size());
  EXPECT_NEAR(result.information(2, 2) / expected_z, 1.0, 0.2);
  EXPECT_NEAR(result.information(4, 4) / result.information(2, 2),
              sum_xx / scene.points_base.size(), 0.15 * sum_xx / scene.points_base.size());
}

TEST(InformationEstimator, InACorridorTheWayAlongItIsWeak) {
  const InformationEstimate result = estimate(makeCorridor());
  ASSERT_EQ(result.weak_directions.size() > 0, true);
  EXPECT_TRUE(isWeak(result, axis(0)));
  for (const int held : {1, 2}) EXPECT_FALSE(isWeak(result, axis(held))) << held;
}

TEST(InformationEstimator, InACornerNothingIsWeak) {
  const InformationEstimate result = estimate(makeCorner());
  EXPECT_TRUE(result.weak_directions.empty());
  // As many points on the ground as on each wall would give equal shares.
  const Eigen::Vector3d shares = result.information.diagonal().head<3>();
  EXPECT_LT(shares.maxCoeff() / shares.minCoeff(), 3.0);
}

TEST(InformationEstimator, OnASphereTurningIsWeakAndTranslationIsNot) {
  Scene scene;
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  const auto onSphere = [&] {
    return Eigen::Vector3f(
        10.0f * Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized());
  };
  for (int i = 0; i < 100000; ++i) scene.map_points_base.push_back(onSphere());
  for (int i = 0; i < 1500; ++i) scene.points_base.push_back(onSphere());
  const InformationEstimate result = estimate(scene, {}, {});
  const Eigen::Vector3d translation = result.information.diagonal().head<3>();
  EXPECT_LT(translation.maxCoeff() / translation.minCoeff(), 1.2);
  // Turning by 0.01 rad slides points by 0.1 m along the sphere; held alike it would be 100 times.
  EXPECT_LT(result.information.diagonal().tail<3>().maxCoeff(),
            0.1 * 100.0 * translation.minCoeff());
}

TEST(InformationEstimator, AnOffsetFromTheOptimumShowsInTheGradient) {
  Scene scene = makeCorner();
  const Tangent offset = (Tangent() << 0.06, -0.04, 0.05, 0.0, 0.0, 0.0).finished();
  const InformationEstimate result = estimate(scene, {}, boxplus({}, offset));
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT(result.gradient[i] * offset[i], 0.0)
        << i;  // the objective grows away from the optimum
    EXPECT_NEAR(result.gradient[i] / (result.information(i, i) * offset[i]), 1.0, 0.5) << i;
  }
}

/// The same surroundings seen from a base turned by Q: right perturbations turn with it.
TEST(InformationEstimator, TheInformationIsInTheBaseFrame) {
  Scene scene = makeCorridor();
  scene.addSurface({20, 0, 0}, {0, 1.5f, 0}, {0, 0, 1.0f});  // anisotropic, held everywhere
  const Eigen::Quaterniond Q = expSO3({0.3, -0.5, 1.1});
  const Pose T_turned{Q, Eigen::Vector3d::Zero()};
  Scene turned = scene;
  for (Points* points : {&turned.points_base, &turned.map_points_base})
    for (Eigen::Vector3f& p : *points) p = Q.conjugate().cast<float>() * p;
  const Matrix6 A = estimate(scene, {}, {}).information;
  const Matrix6 B = estimate(turned, T_turned, T_turned).information;
  Matrix6 J = Matrix6::Zero();
  J.topLeftCorner<3, 3>() = J.bottomRightCorner<3, 3>() = Q.toRotationMatrix();
  const Matrix6 back = J * B * J.transpose();
  // The samples are drawn in a box that turned, so not to the last digit; without turning back the
  // difference is as large as the matrix.
  for (const int first : {0, 3}) {
    const Eigen::Matrix3d a = A.block<3, 3>(first, first);
    EXPECT_LT((back.block<3, 3>(first, first) - a).norm(), 0.15 * a.norm());
    EXPECT_GT((B.block<3, 3>(first, first) - a).norm(), 0.3 * a.norm());
  }
}

TEST(InformationEstimator, ASubsetOfThePointsStandsForAll) {
  Scene scene = makeCorner();
  InformationConfig subset;
  subset.max_points = 200;
  const Eigen::Vector3d all = estimate(scene, {}, {}).information.diagonal().head<3>();
  const Eigen::Vector3d some = estimate(scene, {}, {}, subset).information.diagonal().head<3>();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(some[i] / all[i], 1.0, 0.35);
}

TEST(InformationEstimator, HasTheSameBitsForAnyNumberOfThreads) {
  Scene scene = makeCorner();
  std::vector<Matrix6> results;
  for (const int threads : {1, 2, 4}) {
    tbb::task_arena arena(threads);
    arena.execute([&] { results.push_back(estimate(scene, {}, {}).information); });
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

/// A single edge that holds nothing is where the graph would tear.
TEST(InformationEstimator, NoDirectionIsLetGoAltogether) {
  Scene scene = makePlane();
  for (const double share : {0.03, 0.2}) {
    InformationConfig config = allPoints();
    config.min_eigenvalue_share = share;
    const Matrix6 information = estimate(scene, {}, {}, config).information;
    for (const int first : {0, 3}) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
          information.block<3, 3>(first, first));
      EXPECT_GE(solver.eigenvalues()[0], 0.9999 * share * solver.eigenvalues()[2]);
    }
  }
}

TEST(InformationEstimator, EigenvaluesAreClampedAndNothingIsNotAnError) {
  Points far_away(50, Eigen::Vector3f(90, 0, 0));
  const InformationEstimator estimator(allPoints());
  const LocalVoxelMap empty{LocalVoxelMapConfig{}};
  const InformationEstimate result =
      estimator.estimate(estimator.gather(far_away, empty, {}, kTau));
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(result.information);
  EXPECT_NEAR(solver.eigenvalues().minCoeff(), InformationConfig().min_eigenvalue, 1e-12);
  EXPECT_EQ(result.weak_directions.size(), 6u);
  EXPECT_EQ(estimator.estimate({}).information, Matrix6::Identity());
}

}  // namespace
}  // namespace revisit_slam
