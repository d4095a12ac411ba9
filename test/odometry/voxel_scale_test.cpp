// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/voxel_scale.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

/// Level planes of 12 x 12 m at some heights.
LocalVoxelMap mapOf(double voxel_size, const std::vector<float>& heights) {
  LocalVoxelMapConfig config;
  config.voxel_size = voxel_size;
  LocalVoxelMap map(config);
  Points points;
  for (const float z : heights)
    for (int x = 0; x < 48; ++x)
      for (int y = 0; y < 48; ++y)
        points.push_back(
            {0.05f + 0.25f * static_cast<float>(x), 0.05f + 0.25f * static_cast<float>(y), z});
  map.insert(points, Pose::identity());
  return map;
}

double after(VoxelScale scale, double reach, int scans,
             const std::vector<float>& heights = {0.1f}) {
  for (int i = 0; i < scans; ++i) {
    scale.observe(reach);
    scale.follow(mapOf(scale.voxelSize(), heights));
  }
  return scale.voxelSize();
}

TEST(VoxelScale, IsTheConfiguredOneWhereScansReachFar) {
  EXPECT_EQ(after({1.0, true}, 15.0, 10), 1.0);
  EXPECT_EQ(after({1.0, true}, 150.0, 10), 1.0);
  EXPECT_EQ(after({0.3, true}, 150.0, 10), 0.3);
}

TEST(VoxelScale, IsATenthToAFortiethOfTheReachOfScansInRooms) {
  for (const double reach : {0.9, 1.9, 4.2, 8.0}) {
    const double voxel_size = after({1.0, true}, reach, 10);
    EXPECT_LE(voxel_size, 0.1 * reach);
    EXPECT_GE(voxel_size, 0.025 * reach);
  }
  EXPECT_EQ(after({1.0, false}, 1.9, 10), 1.0);
}

TEST(VoxelScale, IsSmallerUnderALowCeiling) {
  EXPECT_EQ(after({1.0, true}, 30.0, 10, {0.1f, 3.1f}), 0.5);
  EXPECT_EQ(after({1.0, true}, 30.0, 10, {0.1f, 7.1f}), 1.0);
  EXPECT_EQ(after({1.0, false}, 30.0, 10, {0.1f, 3.1f}), 1.0);
}

TEST(VoxelScale, WhatIsLevelNearTheGroundIsNoCeiling) {
  EXPECT_EQ(after({0.7, true}, 30.0, 10, {0.1f, 1.2f}), 0.7);
  EXPECT_EQ(after({0.35, true}, 30.0, 10, {0.1f, 1.2f}), 0.35);
  EXPECT_EQ(after({0.175, true}, 1.8, 10, {0.1f, 0.7f}), 0.0875);  // but in a model of a room
  std::vector<float> foliage(30);
  for (std::size_t i = 0; i < foliage.size(); ++i)
    foliage[i] = 0.1f + 0.21f * static_cast<float>(i);
  EXPECT_GE(after({0.7, true}, 30.0, 10, foliage), 0.35);
}

TEST(VoxelScale, FollowsFromRoomToYardAndBackButNotAGlanceThroughTheDoor) {
  VoxelScale scale(1.0, true);
  const auto observe = [&](double reach, int scans) {
    for (int i = 0; i < scans; ++i) {
      scale.observe(reach);
      scale.follow(mapOf(scale.voxelSize(), {0.1f}));
    }
    return scale.voxelSize();
  };
  EXPECT_EQ(observe(4.0, 10), 0.25);
  EXPECT_EQ(observe(12.0, 5), 0.25);
  EXPECT_EQ(observe(60.0, 60), 1.0);
  // Once it has grown, half of the reach at which it grew does not shrink it again.
  EXPECT_EQ(observe(10.5, 100), 1.0);
  EXPECT_EQ(observe(4.0, 100), 0.25);
}

}  // namespace
}  // namespace revisit_slam
