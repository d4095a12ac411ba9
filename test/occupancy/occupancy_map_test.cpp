// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/occupancy_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "occupancy/occupancy_scenes.h"

namespace revisit_slam {
namespace {

struct Drive {
  std::vector<SubmapOccupancyPtr> submaps;
  std::vector<Pose> T_map_submap;
};

Drive randomDrive(RandomNumbers& random, int submaps) {
  Drive drive;
  for (int i = 0; i < submaps; ++i) {
    drive.submaps.push_back(randomSubmap(random, 8));
    drive.T_map_submap.push_back(random.pose(8.0));
  }
  return drive;
}

OccupancyMap builtAnew(const Drive& drive, double pose_step) {
  OccupancyConfig config;
  config.pose_step = pose_step;
  OccupancyMap map(config);
  for (unsigned i = 0; i < drive.submaps.size(); ++i)
    map.place({i}, drive.submaps[i], drive.T_map_submap[i]);
  map.compose();
  return map;
}

class OccupancyMapHistory : public ::testing::TestWithParam<double> {};

TEST_P(OccupancyMapHistory, EqualsTheMapBuiltAnewAfterAnySequenceOfMoves) {
  RandomNumbers random(1);
  Drive drive = randomDrive(random, 6);
  OccupancyMap map = builtAnew(drive, GetParam());
  for (int move = 0; move < 30; ++move) {
    const unsigned i = static_cast<unsigned>(random.uniform(0, 6));
    const double size = move % 3 == 0 ? 3.0 : 0.05;
    drive.T_map_submap[i] = drive.T_map_submap[i] * exp(random.tangent(size, 0.02 * size));
    map.place({i}, drive.submaps[i], drive.T_map_submap[i]);
    if (move % 4 != 0) map.compose();
    if (move % 5 != 0) continue;
    map.compose();
    EXPECT_TRUE(same(map.voxels().blocks, builtAnew(drive, GetParam()).voxels().blocks))
        << "after move " << move;
  }
}

INSTANTIATE_TEST_SUITE_P(PoseSteps, OccupancyMapHistory, ::testing::Values(0.0, 0.5, 4.0));

TEST(OccupancyMap, ComposesOnlyWhatASubmapThatMovedReaches) {
  RandomNumbers random(2);
  OccupancyMap map{OccupancyConfig{}};
  const SubmapOccupancyPtr here = randomSubmap(random), there = randomSubmap(random);
  const Pose far{Eigen::Quaterniond::Identity(), {1000, 0, 0}};
  EXPECT_TRUE(map.place({0}, here, {}));
  EXPECT_TRUE(map.place({1}, there, far));
  const std::size_t both = map.compose();
  EXPECT_EQ(map.compose(), 0u);
  EXPECT_FALSE(map.place({0}, here, {}));
  EXPECT_TRUE(map.place({1}, there, {far.rotation, {1000, 1, 0}}));
  const std::size_t one = map.compose();
  EXPECT_GT(one, 0u);
  EXPECT_LT(one, both);
}

TEST(OccupancyMap, KnowsWhichSubmapsAreInIt) {
  OccupancyMap map{OccupancyConfig{}};
  EXPECT_FALSE(map.move(SubmapId{3}, Pose::identity()));
}

TEST(OccupancyMap, RoundedPosesStayWithinTheStep) {
  // One voxel, 28 m from the keypose, lands within half a voxel of where it belongs.
  const SubmapOccupancyPtr submap = submapOf({{{55, 5, 0}, 1, 0}});
  RandomNumbers random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Pose T = random.pose(100.0);
    const Eigen::Vector3d wanted = T * Eigen::Vector3d(27.75, 2.75, 0.25);
    const OccupancyVoxels map = mapOf(submap, T);
    double nearest = 1e9;
    for (const Eigen::Vector3f& centre : occupiedCentres(map))
      nearest = std::min(nearest, (centre.cast<double>() - wanted).norm());
    // Half a voxel of rounding, and from the centre to the corner of the voxel that it fell into.
    EXPECT_LT(nearest, 0.25 + 0.5 * std::sqrt(0.75));
  }
}

TEST(OccupancyMap, SmallMovesKeepMostSubmapsWhereTheyAre) {
  RandomNumbers random(4);
  const SubmapOccupancyPtr submap = submapOf({{{0, 0, 0}, 1, 0}});
  OccupancyMap map{OccupancyConfig{}};
  int moved = 0;
  for (unsigned i = 0; i < 200; ++i) {
    const Pose T = random.pose(100.0);
    map.place({i}, submap, T);
    moved += map.place({i}, submap, T * exp(random.tangent(0.002, 1e-5)));
  }
  EXPECT_LT(moved, 20);
}

TEST(OccupancyMap, LaterPassesClearWhatHasGone) {
  const SubmapOccupancyPtr parked = submapOf({{{0, 0, 0}, 1, 0}});
  const SubmapOccupancyPtr gone = submapOf({{{0, 0, 0}, 0, 3}});
  OccupancyMap map{OccupancyConfig{}};
  map.place({0}, parked, {});
  map.compose();
  EXPECT_EQ(occupiedCentres(map.voxels()).size(), 1u);
  map.place({1}, gone, {});
  map.compose();
  EXPECT_TRUE(occupiedCentres(map.voxels()).empty());
  EXPECT_TRUE(map.voxels().blocks[0].free.test(0));
}

TEST(OccupancyMap, WhereRaysOnlyPassedNothingIsWhateverTheProbabilities) {
  OccupancyConfig config;
  config.miss = 0.5;
  config.occupied = 0.35;
  OccupancyMap map{config};
  map.place({0}, submapOf({{{0, 0, 0}, 0, 1}}), {});
  map.compose();
  EXPECT_TRUE(occupiedCentres(map.voxels()).empty());
  EXPECT_TRUE(map.voxels().blocks[0].free.test(0));
}

TEST(OccupancyMap, GivesTheCentresOfOccupiedVoxels) {
  const OccupancyVoxels map = mapOf(submapOf({{{-1, 4, 9}, 2, 1}, {{0, 0, 0}, 0, 1}}));
  ASSERT_EQ(occupiedCentres(map).size(), 1u);
  EXPECT_EQ(occupiedCentres(map)[0], Eigen::Vector3f(-0.25f, 2.25f, 4.75f));
}

TEST(OccupancyMap, RefusesVoxelsOfAnotherSize) {
  OccupancyMap map{OccupancyConfig{}};
  EXPECT_THROW(map.place({0}, submapOf({}, 0.25), {}), std::invalid_argument);
}

}  // namespace
}  // namespace revisit_slam
