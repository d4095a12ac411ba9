// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_builder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "occupancy/occupancy_scenes.h"
#include "revisit_slam/types/se3.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

Pose at(double x, double yaw = 0.0) {
  return {expSO3({0, 0, yaw}), {x, 0, 0}};
}

struct Counts {
  unsigned hits, misses;
};

Counts countsAt(const SubmapOccupancy& submap, const Voxel& voxel) {
  const auto entry = submap.firstFrom(blockOf(voxel));
  if (entry == submap.entries().end() || entry->block != blockOf(voxel)) return {0, 0};
  const BlockCounts counts = submap.counts(*entry);
  return {counts.hits(bitOf(voxel)), counts.misses(bitOf(voxel))};
}

/// A builder that takes every scan.
OccupancyBuilder greedyBuilder() {
  OccupancyConfig config;
  config.scan_spacing = 0.0;
  return OccupancyBuilder(config);
}

TEST(BlockCounter, CountsAndStaysAtItsMost) {
  BlockCounter counter;
  VoxelMask one, other;
  one.set(7);
  other.set(300);
  for (int i = 0; i < 100; ++i) {
    counter.add(one);
    if (i < 37) counter.add(other);
  }
  EXPECT_EQ(counter.at(7), BlockCounter::kMost);
  EXPECT_EQ(counter.at(300), 37);
  EXPECT_EQ(counter.at(8), 0);
}

TEST(OccupancyBuilder, TakesAScanAfterEveryWayOrTurn) {
  OccupancyBuilder builder{OccupancyConfig{}};
  EXPECT_TRUE(builder.insert({{5, 0, 0}}, at(0.0), {0, 0, 0}));
  EXPECT_FALSE(builder.insert({{5, 0, 0}}, at(1.9), {0, 0, 0}));
  EXPECT_TRUE(builder.insert({{5, 0, 0}}, at(2.0), {0, 0, 0}));
  EXPECT_FALSE(builder.insert({{5, 0, 0}}, at(2.5, 0.3), {0, 0, 0}));
  EXPECT_TRUE(builder.insert({{5, 0, 0}}, at(2.5, 0.4), {0, 0, 0}));
}

TEST(OccupancyBuilder, ARobotThatStandsAddsNothing) {
  OccupancyBuilder builder{OccupancyConfig{}};
  for (int scan = 0; scan < 1000; ++scan) builder.insert({{5, 0, 0}}, at(0.0), {0, 0, 0});
  EXPECT_EQ(countsAt(*builder.close(), {10, 0, 0}).hits, 1u);
}

TEST(OccupancyBuilder, CountsAVoxelOnceAScan) {
  OccupancyBuilder builder = greedyBuilder();
  for (int scan = 0; scan < 2; ++scan)
    builder.insert({{5.1f, 0.1f, 0.1f}, {5.2f, 0.2f, 0.2f}, {5.3f, 0.1f, 0.3f}}, at(0.0),
                   {0, 0, 0});
  const SubmapOccupancyPtr submap = builder.close();
  EXPECT_EQ(countsAt(*submap, {10, 0, 0}).hits, 2u);
  EXPECT_EQ(countsAt(*submap, {5, 0, 0}).misses, 2u);
}

TEST(OccupancyBuilder, KeepsTheProportionOfManyCounts) {
  OccupancyBuilder builder = greedyBuilder();
  for (int scan = 0; scan < 24; ++scan)  // something stood there during a third of the scans
    builder.insert({{scan % 3 == 0 ? 5.2f : 9.2f, 0.2f, 0.2f}}, at(0.0), {0, 0, 0});
  const SubmapOccupancyPtr submap = builder.close();
  const Counts crossed = countsAt(*submap, {10, 0, 0});
  EXPECT_EQ(crossed.hits, 2u);
  EXPECT_EQ(crossed.misses, 3u);
  EXPECT_EQ(countsAt(*submap, {5, 0, 0}).misses, 3u);
}

TEST(OccupancyBuilder, OneHitAmongManyMissesIsNotForgotten) {
  OccupancyBuilder builder = greedyBuilder();
  for (int scan = 0; scan < 40; ++scan)
    builder.insert({{scan == 7 ? 5.2f : 9.2f, 0.2f, 0.2f}}, at(0.0), {0, 0, 0});
  EXPECT_EQ(countsAt(*builder.close(), {10, 0, 0}).hits, 1u);
}

/// Its own roof, or dust around it.
TEST(OccupancyBuilder, NothingIsOccupiedWhereTheRobotDrove) {
  OccupancyConfig config;
  OccupancyBuilder builder(config);
  const Eigen::Vector3d sensor(0.2, 0.0, 1.8);
  const auto ahead = [](double x) { return Pose{Eigen::Quaterniond::Identity(), {x, 0.2, 0.1}}; };
  for (int i = 0; i < 20; ++i) {
    builder.insert({{1.0f, 0.0f, 1.3f}, {0.0f, 0.0f, -0.3f}, {0.3f, 3.0f, 1.3f}}, ahead(2.5 * i),
                   sensor);
    builder.drive(ahead(2.5 * std::max(i - 1, 0)), ahead(2.5 * i), sensor);
  }
  const OccupancyVoxels map = mapOf(builder.close());
  const Points centres = occupiedCentres(map);
  std::size_t ground = 0, beside = 0;
  for (const Eigen::Vector3f& p : centres) {
    ground += p.z() < 0.0f;
    beside += p.y() > 2.0f;
    const bool in_the_way = p.x() > 0.3f && p.x() < 47.0f && p.y() > 0.0f && p.y() < 0.5f;
    EXPECT_TRUE(!in_the_way || p.z() < 0.5f) << p.transpose();
  }
  EXPECT_GE(ground, 15u);
  EXPECT_GE(beside, 15u);
}

/// Whatever the angle between submap and map, and also between the poses of scans.
TEST(OccupancyBuilder, TheWayIsFreeInAMapThatIsTurned) {
  const Eigen::Vector3d sensor(0, 0, 1.8);
  const auto ahead = [](double x) { return Pose{Eigen::Quaterniond::Identity(), {x, 0, 0}}; };
  for (const double angle : {0.0, 0.3, 0.6}) {
    OccupancyBuilder builder({});
    Points dust;
    for (int x = -4; x < 120; ++x)
      for (int y = -10; y < 10; ++y)
        dust.emplace_back(0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), 1.2f);
    builder.insert(dust, {}, sensor);
    for (int i = 1; i <= 10; ++i) builder.drive(ahead(1.0 * (i - 1)), ahead(1.0 * i), sensor);
    const Pose T_map_submap{expSO3({0, 0, angle}), {0.1, 0.2, 0.0}};
    const OccupancyVoxels map = mapOf(builder.close(), T_map_submap);
    for (int cm = 0; cm < 1000; ++cm) {
      const Voxel on_way =
          voxelOf<double>(T_map_submap * Eigen::Vector3d(0.01 * cm, 0.0, 1.2) / 0.5);
      for (const OccupancyBlock& block : map.blocks)
        EXPECT_TRUE(block.block != blockOf(on_way) || block.free.test(bitOf(on_way))) << cm;
    }
  }
}

/// A sensor without a base below it.
TEST(OccupancyBuilder, ASensorThatIsTheBaseFreesItsOwnVoxel) {
  OccupancyBuilder builder({});
  builder.insert({{0.1f, 0.1f, 0.1f}, {5.0f, 0.0f, 0.0f}}, {}, {0, 0, 0});
  builder.drive({}, {}, {0, 0, 0});
  EXPECT_EQ(occupiedCentres(mapOf(builder.close())).size(), 1u);
}

TEST(OccupancyBuilder, RaysOfSeveralSensorsBeginAtTheirOwn) {
  OccupancyBuilder builder({});
  builder.insert({{5.2f, 0.2f, 0.2f}, {5.2f, 8.2f, 0.2f}}, {}, {0, 0, 0},
                 {{{0.2, 0.2, 0.2}, 1}, {{0.2, 8.2, 0.2}, 2}});
  const OccupancyVoxels map = mapOf(builder.close());
  const auto isFree = [&](double x, double y) {
    const Voxel voxel = voxelOf<double>(Eigen::Vector3d(x, y, 0.2) / 0.5);
    for (const OccupancyBlock& block : map.blocks)
      if (block.block == blockOf(voxel)) return block.free.test(bitOf(voxel));
    return false;
  };
  EXPECT_TRUE(isFree(2.2, 0.2));
  EXPECT_TRUE(isFree(2.2, 8.2));
  EXPECT_FALSE(isFree(2.6, 4.2));
}

TEST(OccupancyBuilder, IsEmptyOnceClosed) {
  OccupancyBuilder builder{OccupancyConfig{}};
  builder.insert({{5, 0, 0}}, at(0.0), {0, 0, 0});
  EXPECT_FALSE(builder.close()->entries().empty());
  EXPECT_TRUE(builder.close()->entries().empty());
  EXPECT_TRUE(builder.insert({{5, 0, 0}}, at(0.0), {0, 0, 0}));
}

}  // namespace
}  // namespace revisit_slam
