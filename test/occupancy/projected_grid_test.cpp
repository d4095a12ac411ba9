// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/projected_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "occupancy/occupancy_scenes.h"
#include "support/contains.h"

namespace revisit_slam {
namespace {

constexpr int kHalf = 40;  // voxels of half a metre

/// Ground of the given height (in voxels) seen by a robot on it, with free space above.
std::vector<VoxelCounts> groundOf(const std::function<double(int x, int y)>& height) {
  std::vector<VoxelCounts> voxels;
  for (int x = -kHalf; x < kHalf; ++x)
    for (int y = -kHalf; y < kHalf; ++y) {
      const int z = static_cast<int>(std::floor(height(x, y)));
      voxels.push_back({{x, y, z}, 3, 0});
      for (int above = 1; above < 8; ++above) voxels.push_back({{x, y, z + above}, 0, 3});
    }
  return voxels;
}

/// Makes what is there in the column occupied from `low` to `high` voxels above the ground's.
void put(std::vector<VoxelCounts>& voxels, int x, int y, int ground, int low, int high) {
  for (int z = low; z <= high; ++z) {
    for (VoxelCounts& v : voxels)
      if (v.voxel == Voxel(x, y, ground + z)) v.misses = 0;
    voxels.push_back({{x, y, ground + z}, 3, 0});
  }
}

ProjectedGrid gridOf(const std::vector<VoxelCounts>& voxels) {
  return projectedGrid(mapOf(submapOf(voxels)), ProjectedGridConfig{});
}

int stateAt(const ProjectedGrid& grid, double x, double y) {
  const int column = static_cast<int>(std::floor((x - grid.origin.x()) / grid.resolution));
  const int row = static_cast<int>(std::floor((y - grid.origin.y()) / grid.resolution));
  return grid.cells.at(static_cast<std::size_t>(row * grid.width + column));
}

std::size_t occupiedCells(const ProjectedGrid& grid) {
  return static_cast<std::size_t>(
      std::count(grid.cells.begin(), grid.cells.end(), ProjectedGrid::kOccupied));
}

TEST(ProjectedGrid, ThatNoMemoryHoldsIsRefusedWithItsSize) {
  const auto voxels = {VoxelCounts{{0, 0, 0}, 3, 0}, VoxelCounts{{80'000, 80'000, 0}, 3, 0}};
  try {
    gridOf(voxels);
    FAIL();
  } catch (const std::length_error& error) {
    EXPECT_TRUE(contains(error.what(), "1e+09 are allowed")) << error.what();
  }
}

TEST(ProjectedGrid, IsLaidOutRowByRow) {
  std::vector<VoxelCounts> voxels = groundOf([](int, int) { return 0.5; });
  put(voxels, 10, -20, 0, 1, 4);
  const ProjectedGrid grid = gridOf(voxels);
  EXPECT_EQ(grid.cells.size(), static_cast<std::size_t>(grid.width * grid.height));
  EXPECT_EQ(grid.origin, Eigen::Vector2d(-20, -20));
  EXPECT_EQ(grid.width, 80);
  EXPECT_EQ(stateAt(grid, 5.2, -9.8), ProjectedGrid::kOccupied);
  EXPECT_EQ(stateAt(grid, -9.8, 5.2), ProjectedGrid::kFree);
  EXPECT_EQ(occupiedCells(grid), 1u);
}

TEST(ProjectedGrid, ShowsWhatStandsInTheBand) {
  std::vector<VoxelCounts> voxels = groundOf([](int, int) { return -30.5; });
  put(voxels, 0, 0, -31, 1, 1);   // a kerb
  put(voxels, 10, 0, -31, 1, 3);  // a car
  put(voxels, 20, 0, -31, 6, 7);  // a sign above the road
  const ProjectedGrid grid = gridOf(voxels);
  EXPECT_EQ(stateAt(grid, 0.2, 0.2), ProjectedGrid::kFree);
  EXPECT_EQ(stateAt(grid, 5.2, 0.2), ProjectedGrid::kOccupied);
  EXPECT_EQ(stateAt(grid, 10.2, 0.2), ProjectedGrid::kFree);
}

TEST(ProjectedGrid, AHillIsNoObstacle) {
  const auto hill = [](int x, int y) { return 0.15 * x - 0.05 * y; };
  std::vector<VoxelCounts> voxels = groundOf(hill);
  EXPECT_EQ(occupiedCells(gridOf(voxels)), 0u);
  put(voxels, 24, 9, static_cast<int>(std::floor(hill(24, 9))), 1, 4);
  EXPECT_EQ(stateAt(gridOf(voxels), 12.2, 4.7), ProjectedGrid::kOccupied);
}

TEST(ProjectedGrid, ARoofIsNotTheGround) {
  std::vector<VoxelCounts> voxels;
  for (const VoxelCounts& v : groundOf([](int, int) { return 0.5; }))
    if (v.voxel.x() < 8 || v.voxel.x() >= 16) voxels.push_back(v);
  for (int y = -kHalf; y < kHalf; ++y)
    for (int x = 8; x < 16; ++x)  // a whole stack of which only the top, 10 m up, was seen
      voxels.push_back({{x, y, 20}, 3, 0});
  for (int z = 1; z < 20; ++z) voxels.push_back({{8, 0, z}, 3, 0});
  const ProjectedGrid grid = gridOf(voxels);
  EXPECT_EQ(stateAt(grid, 4.2, 0.2), ProjectedGrid::kOccupied);
  EXPECT_EQ(stateAt(grid, 6.2, 0.2), ProjectedGrid::kUnknown);
  EXPECT_EQ(occupiedCells(grid), 1u);
}

/// What is above the robot does not keep it from where it drove; on another level it is no matter.
TEST(ProjectedGrid, WhereTheRobotDroveNothingIs) {
  std::vector<VoxelCounts> voxels = groundOf([](int, int) { return 0.5; });
  for (const int x : {-10, 0, 10}) put(voxels, x, 0, 0, 3, 4);  // dust, or a table
  OccupancyVoxels map = mapOf(submapOf(voxels));
  const auto drive = [&](const Voxel& voxel) {
    for (OccupancyBlock& block : map.blocks)
      if (block.block == blockOf(voxel)) block.driven.set(bitOf(voxel));
  };
  drive({0, 0, 1});
  drive({10, 0, 7});
  const ProjectedGrid grid = projectedGrid(map, ProjectedGridConfig{});
  EXPECT_EQ(stateAt(grid, -4.8, 0.2), ProjectedGrid::kOccupied);
  EXPECT_EQ(stateAt(grid, 0.2, 0.2), ProjectedGrid::kFree);
  EXPECT_EQ(stateAt(grid, 5.2, 0.2), ProjectedGrid::kOccupied);
}

TEST(ProjectedGrid, OfNothingIsEmpty) {
  EXPECT_TRUE(projectedGrid(OccupancyVoxels{}, {}).cells.empty());
}

}  // namespace
}  // namespace revisit_slam
