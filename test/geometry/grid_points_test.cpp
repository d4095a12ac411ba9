// SPDX-License-Identifier: MIT
#include "revisit_slam/geometry/grid_points.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

template <typename Scalar>
void expectPlaced(Scalar scale, double tolerance) {
  RandomNumbers random(1);
  const Pose T = random.pose(20.0);
  for (const std::size_t count : {0u, 1u, 7u, 256u, 257u, 1000u}) {
    const Points points = random.cloud(count, 80.0);
    std::size_t next = 0;
    forEachInGrid(points, T, scale, [&](const GridPoints<Scalar>& placed, std::size_t i) {
      const Eigen::Vector3d expected = T * Eigen::Vector3d(points[next++].cast<double>());
      const Eigen::Matrix<Scalar, 3, 1> point = placed.point(i);
      EXPECT_LT((point.template cast<double>() - expected).norm(), tolerance);
      EXPECT_EQ(placed.voxel(i), voxelOf<Scalar>(point * scale));
    });
    EXPECT_EQ(next, count);
  }
}

TEST(GridPoints, AreMovedAndFindTheirVoxels) {
  expectPlaced<float>(2.0f, 3e-5);
  expectPlaced<double>(4.0, 1e-12);
}

TEST(GridPoints, StayWhereNothingMovesThem) {
  RandomNumbers random(2);
  const Points points = random.cloud(200, 50.0);
  GridPoints<float> placed;
  toGrid(points.data(), points.size(), 0.7f, placed);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(placed.point(i), points[i]);
    EXPECT_EQ(placed.voxel(i), voxelOf<float>(points[i] * 0.7f));
  }
}

}  // namespace
}  // namespace revisit_slam
