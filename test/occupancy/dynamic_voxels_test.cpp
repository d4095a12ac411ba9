// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/dynamic_voxels.h"

#include <gtest/gtest.h>

#include "occupancy/occupancy_scenes.h"

namespace revisit_slam {
namespace {

bool isOccupied(const OccupancyVoxels& map, const Voxel& voxel) {
  for (const OccupancyBlock& block : map.blocks)
    if (block.block == blockOf(voxel)) {
      EXPECT_NE(block.occupied.test(bitOf(voxel)), block.free.test(bitOf(voxel)));
      return block.occupied.test(bitOf(voxel));
    }
  return false;
}

TEST(DynamicVoxels, AreFreeWhereNothingElseIs) {
  const Voxel moved(2, 0, 1), shared(3, 0, 1), beside(2, 1, 1), standing(8, 0, 1);
  OccupancyVoxels map =
      mapOf(submapOf({{moved, 2, 1}, {shared, 2, 1}, {beside, 2, 1}, {standing, 2, 1}}));
  for (const Voxel& voxel : {moved, shared, beside, standing}) EXPECT_TRUE(isOccupied(map, voxel));
  DynamicVoxels dynamic(0.5);
  dynamic.add({{1.6f, 0.1f, 0.6f}}, {{1.9f, 0.1f, 0.6f}, {1.1f, 0.2f, 0.7f}});
  dynamic.clear(map);
  EXPECT_FALSE(isOccupied(map, moved));
  EXPECT_FALSE(isOccupied(map, beside));
  EXPECT_TRUE(isOccupied(map, shared));
  EXPECT_TRUE(isOccupied(map, standing));
}

}  // namespace
}  // namespace revisit_slam
