// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/point_map.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

TEST(PointMap, KeepsTheFirstPointOfEachVoxelOfTheWholeDrive) {
  RandomNumbers random(1);
  constexpr double voxel_size = 0.4;
  PointMap map(voxel_size);
  std::set<std::array<double, 3>> seen;
  Points expected;
  for (int scan = 0; scan < 20; ++scan) {
    const Points points = random.cloud(500, 5.0);
    const Pose T = random.pose(3.0);
    map.insert(points, T);
    for (const auto& p : points) {
      const Eigen::Vector3d in_world = T.rotationMatrix() * p.cast<double>() + T.translation;
      const Eigen::Array3d voxel = (in_world / voxel_size).array().floor();
      if (seen.insert({voxel.x(), voxel.y(), voxel.z()}).second)
        expected.push_back(in_world.cast<float>());
    }
  }
  EXPECT_LT(expected.size(), 9000u);
  EXPECT_EQ(map.points(), expected);
}

TEST(PointMap, KeepsTheIntensitiesOfItsPoints) {
  PointMap map(0.1);
  map.insert({{5.0f, 5.0f, 5.0f}}, {});
  map.insert({{1.0f, 2.0f, 3.0f}, {5.0f, 5.0f, 5.0f}, {4.0f, 2.0f, 3.0f}}, {}, {1.0f, 2.0f, 3.0f});
  EXPECT_EQ(map.intensities(), (std::vector<float>{0.0f, 1.0f, 3.0f}));
}

TEST(PointMap, TakesTheSamePointsOnce) {
  PointMap map(0.1);
  EXPECT_TRUE(map.points().empty());
  const Points points{{1.05f, 2.05f, 3.05f}, {-1.05f, 2.05f, 3.05f}, {1.06f, 2.06f, 3.06f}};
  for (int i = 0; i < 3; ++i) map.insert(points, {});
  EXPECT_EQ(map.points(), (Points{points[0], points[1]}));
}

}  // namespace
}  // namespace revisit_slam
