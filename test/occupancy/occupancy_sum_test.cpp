// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_sum.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "occupancy/occupancy_scenes.h"

namespace revisit_slam {
namespace {

TEST(OccupancySum, ItsPartsTogetherAreTheMap) {
  RandomNumbers random(5);
  OccupancyConfig config;
  OccupancyMap map(config);
  OccupancySum left(config), right(config);
  const auto is_left = [](const Voxel& block) { return block.x() < 1; };
  const auto is_right = [&](const Voxel& block) { return !is_left(block); };
  for (unsigned i = 0; i < 6; ++i) {
    const SubmapOccupancyPtr submap = randomSubmap(random, 8);
    const Pose T_map_submap = random.pose(8.0);
    map.place({i}, submap, T_map_submap);
    left.add({i}, *submap, T_map_submap, is_left);
    right.add({i}, *submap, T_map_submap, is_right);
  }
  map.compose();
  std::vector<OccupancyBlock> blocks = left.blocks(), others = right.blocks();
  EXPECT_FALSE(blocks.empty());
  EXPECT_FALSE(others.empty());
  blocks.insert(blocks.end(), others.begin(), others.end());
  EXPECT_TRUE(same(blocks, map.voxels().blocks));
}

TEST(OccupancySum, RefusesVoxelsOfAnotherSize) {
  OccupancySum sum{OccupancyConfig{}};
  EXPECT_THROW(sum.add({0}, *submapOf({}, 0.25), {}, [](const Voxel&) { return true; }),
               std::invalid_argument);
}

}  // namespace
}  // namespace revisit_slam
