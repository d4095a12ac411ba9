// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/moment_grid.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr double kEdge = 2.1;
const Eigen::Vector3d kPlace(-3.0, 4.5, 0.7);

Eigen::Array3d cubeOf(const Eigen::Vector3d& point) {
  return (point / kEdge).array().floor();
}

PointMoments aroundByRule(const Points& points) {
  PointMoments around;
  for (const Eigen::Vector3f& point : points)
    if ((cubeOf(point.cast<double>()) - cubeOf(kPlace)).abs().maxCoeff() <= 1.0)
      around.add(point - kPlace.cast<float>());
  return around;
}

void expectSame(const PointMoments& a, const PointMoments& b) {
  EXPECT_EQ(a.count, b.count);
  EXPECT_LT((a.sum - b.sum).norm(), 1e-4f * b.count);
  EXPECT_LT((a.squares - b.squares).norm(), 1e-4f * b.count);
}

TEST(MomentGrid, HasTheMomentsOfTheCubesAroundAPlace) {
  RandomNumbers random(1);
  const Points points = random.cloud(3000, 12.0);
  MomentGrid grid(kEdge);
  for (const Eigen::Vector3f& point : points) grid.add(point.cast<double>());
  const PointMoments expected = aroundByRule(points);
  ASSERT_GT(expected.count, 20.0f);
  expectSame(grid.around(kPlace), expected);
  EXPECT_EQ(grid.around({500.0, 0.0, 0.0}).count, 0.0f);
}

TEST(MomentGrid, ForgetsWhatIsFarAndTakesPointsAgain) {
  RandomNumbers random(2);
  const Points points = random.cloud(3000, 12.0);
  MomentGrid grid(kEdge);
  for (const Eigen::Vector3f& point : points) grid.add(point.cast<double>() + 300.0 * kPlace);
  grid.dropBeyond(Eigen::Vector3d::Zero(), 40.0);
  EXPECT_EQ(grid.size(), 0u);
  EXPECT_EQ(grid.around(300.0 * kPlace).count, 0.0f);
  for (const Eigen::Vector3f& point : points) grid.add(point.cast<double>());
  grid.dropBeyond(Eigen::Vector3d::Zero(), 40.0);
  expectSame(grid.around(kPlace), aroundByRule(points));
}

}  // namespace
}  // namespace revisit_slam
