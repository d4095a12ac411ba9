// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/scan_objective.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

constexpr double kSigma = 0.5;
const PointToPoint kMatch{{3, 1, 2}, {0.3, 0.1, -0.2}};

/// Sum of weights and rms of one match, with the base turned by 90 degrees about x.
NormalEquations add(const LocalShape& shape, const RegistrationConfig& config = {}) {
  const Eigen::Matrix3d R = expSO3({M_PI / 2, 0, 0}).toRotationMatrix();
  NormalEquations equations;
  ScanObjective(config, kSigma).add(kMatch, shape, {}, R, equations);
  return equations;
}

double robust(double squared) {
  return GemanMcClure::ofSquaredScale(kSigma).weight(squared);
}

TEST(ScanObjective, WeighsAMatchByItsLocalShape) {
  const RegistrationConfig config;
  const double point = robust(kMatch.squared());
  const auto weight = [&](ShapeKind kind, float points) {
    return add({kind, Eigen::Vector3f::Zero(), points}).weight();
  };
  EXPECT_DOUBLE_EQ(weight(ShapeKind::sparse, 500.0f), config.sparse_weight * point);
  EXPECT_DOUBLE_EQ(weight(ShapeKind::scattered, 30.0f), 30.0 / config.scattered_points * point);
  EXPECT_DOUBLE_EQ(weight(ShapeKind::scattered, 500.0f), point);
}

TEST(ScanObjective, OfAScatteredMatchLeavesOutWhatIsUnknownAcrossTheRings) {
  const RegistrationConfig config;
  const Eigen::Vector3d across = Eigen::Vector3d(1, 2, 2) / 3.0;
  const auto of = [&](double unknown, ShapeKind kind) {
    NormalEquations equations;
    ScanObjective(config, kSigma)
        .add(kMatch, {kind, Eigen::Vector3f::UnitZ(), 500.0f}, {across, unknown},
             Eigen::Matrix3d::Identity(), equations);
    return equations;
  };
  const NormalEquations blind = of(1.0, ShapeKind::scattered);
  const double e = across.dot(kMatch.r), weight = robust(kMatch.squared() - e * e);
  EXPECT_NEAR(across.dot(blind.g().head<3>()), 0.0, 1e-12);
  EXPECT_NEAR(across.dot(blind.H().topLeftCorner<3, 3>() * across), 0.0, 1e-12);
  const Eigen::Vector3d along(0, -M_SQRT1_2, M_SQRT1_2);
  EXPECT_NEAR(along.dot(blind.g().head<3>()), weight * along.dot(kMatch.r), 1e-12);
  EXPECT_NEAR(of(0.75, ShapeKind::scattered).H().trace(),
              of(0.0, ShapeKind::scattered).H().trace() * robust(kMatch.squared() - 0.75 * e * e) /
                      robust(kMatch.squared()) -
                  0.75 * robust(kMatch.squared() - 0.75 * e * e) *
                      (1.0 + kMatch.p.cross(across).squaredNorm()),
              1e-9);
  EXPECT_EQ(of(1.0, ShapeKind::planar).H(), of(0.0, ShapeKind::planar).H());
}

TEST(ScanObjective, OfAPlaneIsTheDistanceToItAndALittleOfThatWithinIt) {
  const RegistrationConfig config;
  // The normal is z of the odometry frame, y of the base.
  const NormalEquations equations = add({ShapeKind::planar, {0, 0, 1}, 100.0f});
  const double e = kMatch.r.y(), weight = robust(e * e);
  EXPECT_NEAR(equations.rms(), std::abs(e), 1e-12);
  EXPECT_NEAR(equations.weight(), (1.0 + config.within_plane_weight) * weight, 1e-12);
  EXPECT_NEAR(equations.H()(1, 1), (1.0 + config.within_plane_weight) * weight, 1e-9);
  EXPECT_NEAR(equations.H()(0, 0), config.within_plane_weight * weight, 1e-9);
}

TEST(ScanObjective, CountsWhatMovesAlongWithTheSensor) {
  const RegistrationConfig config;
  const auto ring_weight = [&](ShapeKind kind, const RegistrationConfig& with) {
    return add({kind, {0, 0, 1}, 100.0f}, with).ringWeight();
  };
  EXPECT_DOUBLE_EQ(ring_weight(ShapeKind::sparse, config),
                   config.sparse_weight * robust(kMatch.squared()));
  EXPECT_DOUBLE_EQ(ring_weight(ShapeKind::planar, config),
                   config.within_plane_weight * robust(kMatch.r.y() * kMatch.r.y()));
  EXPECT_EQ(ring_weight(ShapeKind::scattered, config), 0.0);
  RegistrationConfig points;
  points.planes = false;
  EXPECT_EQ(ring_weight(ShapeKind::sparse, points), 0.0);
}

TEST(ScanObjective, IsPointToPointEverywhereWithoutPlanes) {
  RegistrationConfig config;
  config.planes = false;
  for (const ShapeKind kind : {ShapeKind::sparse, ShapeKind::planar, ShapeKind::scattered}) {
    const NormalEquations equations = add({kind, {0, 0, 1}, 7.0f}, config);
    EXPECT_DOUBLE_EQ(equations.weight(), robust(kMatch.squared()));
    EXPECT_DOUBLE_EQ(equations.rms(), kMatch.r.norm());
  }
}

}  // namespace
}  // namespace revisit_slam
