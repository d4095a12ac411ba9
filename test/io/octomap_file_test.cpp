// SPDX-License-Identifier: MIT
#include "revisit_slam/io/octomap_file.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "occupancy/occupancy_scenes.h"
#include "support/temporary_folder.h"

namespace revisit_slam {
namespace {

octomap::point3d pointOf(const Voxel& voxel, double resolution) {
  const Eigen::Vector3f p =
      static_cast<float>(resolution) * (voxel.cast<float>().array() + 0.5f).matrix();
  return {p.x(), p.y(), p.z()};
}

/// The tree that OctoMap itself makes of the map.
octomap::OcTree treeOf(const OccupancyVoxels& map) {
  octomap::OcTree tree(map.resolution);
  for (const OccupancyBlock& block : map.blocks) {
    const auto put = [&](const VoxelMask& mask, float log_odds) {
      mask.forEach([&](int bit) {
        tree.setNodeValue(pointOf(voxelAt(block.block, bit), map.resolution), log_odds, true);
      });
    };
    put(block.occupied, 1.0f);
    put(block.free, -1.0f);
  }
  tree.updateInnerOccupancy();
  return tree;
}

std::vector<OccupancyVoxels> someMaps() {
  RandomNumbers random(1);
  std::vector<VoxelCounts> hall;  // large enough for whole blocks to become one node
  for (int x = -24; x < 24; ++x)
    for (int y = -24; y < 24; ++y)
      for (int z = -3; z < 21; ++z) {
        const bool wall = z == -3 || x == -24 || y == 23;
        hall.push_back({{x, y, z}, wall ? 1 : 0, wall ? 0 : 1});
      }
  return {mapOf(submapOf({{{-1, 4, 9}, 2, 1}})), mapOf(randomSubmap(random), random.pose(500.0)),
          mapOf(submapOf(hall, 0.1)), mapOf(submapOf(hall, 0.25), random.pose(50.0))};
}

TEST(OctomapFile, IsWhatOctomapWrites) {
  const TemporaryFolder folder;
  for (const OccupancyVoxels& map : someMaps()) {
    writeOctomap(folder.file("map.bt"), map);
    octomap::OcTree tree = treeOf(map);
    ASSERT_TRUE(tree.writeBinary(folder.file("theirs.bt")));
    EXPECT_EQ(textOf(folder.file("map.bt")), textOf(folder.file("theirs.bt")));
  }
}

TEST(OctomapFile, OctomapReadsEveryVoxel) {
  const TemporaryFolder folder;
  const OccupancyVoxels map = someMaps()[1];
  writeOctomap(folder.file("map.bt"), map);
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(folder.file("map.bt")));
  EXPECT_EQ(tree.getResolution(), map.resolution);
  for (const OccupancyBlock& block : map.blocks)
    for (int bit = 0; bit < kBlockVoxels; ++bit) {
      const octomap::OcTreeNode* node = tree.search(pointOf(voxelAt(block.block, bit), 0.5));
      ASSERT_EQ(node != nullptr, block.occupied.test(bit) || block.free.test(bit));
      if (node == nullptr) continue;
      EXPECT_EQ(tree.isNodeOccupied(node), block.occupied.test(bit));
    }
}

TEST(OctomapFile, AnEmptyMapIsAnEmptyTree) {
  const TemporaryFolder folder;
  writeOctomap(folder.file("map.bt"), OccupancyVoxels{0.5, {}});
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(folder.file("map.bt")));
  EXPECT_EQ(tree.size(), 0u);
}

TEST(OctomapFile, RefusesAMapThatIsTooLargeAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  const std::string path = folder.with("map.bt", "old");
  const auto map = [](int x) { return mapOf(submapOf({{{x, 0, 0}, 1, 0}})); };
  EXPECT_THROW(writeOctomap(path, map(32768)), std::runtime_error);
  EXPECT_EQ(textOf(path), "old");
  writeOctomap(path, map(32767));
  EXPECT_NE(textOf(path), "old");
}

}  // namespace
}  // namespace revisit_slam
