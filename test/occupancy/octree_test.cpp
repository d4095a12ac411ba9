// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/octree.h"

#include <gtest/gtest.h>

#include "occupancy/occupancy_scenes.h"

namespace revisit_slam {
namespace {

TEST(Octree, LeavesAreAtTheClampingThresholds) {
  const auto tree = octreeOf(mapOf(submapOf({{{-1, 4, 9}, 2, 1}, {{-2, 4, 9}, 0, 1}})));
  ASSERT_EQ(tree->getNumLeafNodes(), 2u);
  EXPECT_EQ(tree->getResolution(), 0.5);
  const auto* occupied = tree->search(-0.25, 2.25, 4.75);
  const auto* free = tree->search(-0.75, 2.25, 4.75);
  ASSERT_TRUE(occupied && free);
  EXPECT_EQ(occupied->getLogOdds(), tree->getClampingThresMaxLog());
  EXPECT_EQ(free->getLogOdds(), tree->getClampingThresMinLog());
}

TEST(Octree, EqualChildrenAreOneNode) {
  std::vector<VoxelCounts> room;  // 16 voxels a side, free but for one of them
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y)
      for (int z = 0; z < 16; ++z) room.push_back({{x, y, z}, x + y + z == 0 ? 1 : 0, 1});
  const auto tree = octreeOf(mapOf(submapOf(room)));
  EXPECT_EQ(tree->getNumLeafNodes(), 7u * 4 + 1);
  EXPECT_EQ(tree->search(7.75, 7.75, 7.75), tree->search(4.25, 4.25, 4.25));
  const std::size_t nodes = tree->size();
  tree->toMaxLikelihood();
  tree->prune();
  EXPECT_EQ(tree->size(), nodes);
}

TEST(Octree, ReachesToTheBorderOf16LevelsAndNoFarther) {
  const auto map = [](int x) { return mapOf(submapOf({{{x, 0, 0}, 1, 0}})); };
  EXPECT_TRUE(octreeOf(map(32767))->search(16383.75, 0.25, 0.25));
  EXPECT_TRUE(octreeOf(map(-32768))->search(-16383.75, 0.25, 0.25));
  EXPECT_THROW(octreeOf(map(32768)), std::runtime_error);
  EXPECT_THROW(octreeOf(map(-32769)), std::runtime_error);
}

TEST(Octree, AMapBeyondTheBorderIsHandedOutInTiles) {
  const auto map = mapOf(submapOf({{{40000, 3, 0}, 1, 0}, {{-5, 3, 0}, 1, 0}}));
  EXPECT_FALSE(fitsOctree(map));
  std::vector<Eigen::Vector3d> occupied;
  forEachOctreeTile(map, [&](const OctreeTile& tile) {
    for (auto leaf = tile.tree->begin_leafs(); leaf != tile.tree->end_leafs(); ++leaf)
      occupied.push_back(tile.origin_map + Eigen::Vector3d(leaf.getX(), leaf.getY(), leaf.getZ()));
  });
  ASSERT_EQ(occupied.size(), 2u);
  EXPECT_EQ(occupied[0], Eigen::Vector3d(-2.25, 1.75, 0.25));
  EXPECT_EQ(occupied[1], Eigen::Vector3d(20000.25, 1.75, 0.25));
}

}  // namespace
}  // namespace revisit_slam
