// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/submap_occupancy.h"

#include <gtest/gtest.h>

#include "occupancy/occupancy_scenes.h"

namespace revisit_slam {
namespace {

TEST(OccupancyBlock, EveryVoxelHasItsOwnBit) {
  const Voxel block(-3, 2, -1);
  for (int bit = 0; bit < kBlockVoxels; ++bit) {
    const Voxel voxel = voxelAt(block, bit);
    EXPECT_EQ(blockOf(voxel), block);
    EXPECT_EQ(bitOf(voxel), bit);
  }
}

TEST(SubmapOccupancy, GivesBackWhatWasPutIn) {
  RandomNumbers random(1);
  std::vector<VoxelCounts> voxels;
  for (int i = 0; i < 300; ++i) voxels.push_back({{3 * i - 400, i % 7, -i}, i % 4, i / 4 % 4});
  const SubmapOccupancyPtr submap = submapOf(voxels);
  for (const VoxelCounts& v : voxels) {
    const auto entry = submap->firstFrom(blockOf(v.voxel));
    if (v.hits + v.misses == 0) continue;
    ASSERT_NE(entry, submap->entries().end());
    ASSERT_EQ(entry->block, blockOf(v.voxel));
    const BlockCounts counts = submap->counts(*entry);
    EXPECT_EQ(counts.hits(bitOf(v.voxel)), static_cast<unsigned>(v.hits));
    EXPECT_EQ(counts.misses(bitOf(v.voxel)), static_cast<unsigned>(v.misses));
  }
}

TEST(SubmapOccupancy, KeepsNoBlockOfWhichNothingIsKnown) {
  EXPECT_TRUE(submapOf({{{1, 2, 3}, 0, 0}})->entries().empty());
}

TEST(SubmapOccupancy, PaysForTheCountsThatOccurOnly) {
  const std::size_t one = submapOf({{{0, 0, 0}, 0, 1}})->bytes();
  const std::size_t two = submapOf({{{0, 0, 0}, 1, 1}})->bytes();
  EXPECT_EQ(two - one, sizeof(VoxelMask));
}

}  // namespace
}  // namespace revisit_slam
