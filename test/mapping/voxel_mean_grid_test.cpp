// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/voxel_mean_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(VoxelMeanGrid, KeepsTheMeanOfEachVoxelInOrder) {
  VoxelMeanGrid grid(0.5);
  grid.insert({{0.1f, 0.1f, 0.1f}, {-3.0f, 0.0f, 0.0f}, {0.3f, 0.2f, 0.1f}});
  const VoxelMeans means = grid.take();
  ASSERT_EQ(means.points.size(), 2u);
  EXPECT_TRUE(means.points[0].isApprox(Eigen::Vector3f(-3.0f, 0.0f, 0.0f)));
  EXPECT_TRUE(means.points[1].isApprox(Eigen::Vector3f(0.2f, 0.15f, 0.1f), 1e-5f));
  EXPECT_TRUE(std::is_sorted(means.keys.begin(), means.keys.end()));
}

TEST(VoxelMeanGrid, IsEmptyOnceTaken) {
  VoxelMeanGrid grid(0.5);
  grid.insert({{1, 2, 3}});
  EXPECT_EQ(grid.take().points.size(), 1u);
  EXPECT_EQ(grid.voxels(), 0u);
  EXPECT_TRUE(grid.take().points.empty());
}

TEST(VoxelMeanGrid, MovesPointsIntoItsFrame) {
  RandomNumbers random(1);
  const Pose T = random.pose(10.0);
  VoxelMeanGrid grid(0.5);
  grid.insert({{1, 2, 3}}, T);
  const Eigen::Vector3d expected = T * Eigen::Vector3d(1, 2, 3);
  EXPECT_LT((grid.take().points[0].cast<double>() - expected).norm(), 1e-5);
}

TEST(VoxelMeanGrid, StaysExactWhereTheRobotStandsForHours) {
  VoxelMeanGrid grid(0.5);
  for (int scan = 0; scan < 100000; ++scan)
    grid.insert({{80.12f, 0.2f, 0.2f}, {80.14f, 0.2f, 0.2f}});
  EXPECT_NEAR(grid.take().points[0].x(), 80.13f, 2e-5);
}

}  // namespace
}  // namespace revisit_slam
