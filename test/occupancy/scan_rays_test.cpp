// SPDX-License-Identifier: MIT
#include "revisit_slam/occupancy/scan_rays.h"

#include <gtest/gtest.h>

#include <set>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

using Voxels = std::set<Voxel, BlockOrder>;

struct Seen {
  Voxels hit, miss;
};

Seen cast(const Points& points, const Pose& T_g_b = {}, const Eigen::Vector3d& sensor_b = {0, 0, 0},
          double max_ray = 30.0) {
  ScanRays rays(0.5, max_ray);
  Seen seen;
  for (const ScanRaysBlock& block : rays.cast(points, T_g_b, sensor_b)) {
    block.hit.forEach([&](int bit) { seen.hit.insert(voxelAt(block.block, bit)); });
    block.miss.forEach([&](int bit) { seen.miss.insert(voxelAt(block.block, bit)); });
  }
  return seen;
}

Voxel voxelAround(const Eigen::Vector3d& p) {
  return voxelOf<double>(p / 0.5);
}

TEST(ScanRays, OneRayPassesWhatLiesBeforeItsPoint) {
  const Seen seen = cast({{-5.2f, 0.2f, 0.2f}}, {}, {0.2, 0.2, 0.2});
  EXPECT_EQ(seen.hit, (Voxels{{-11, 0, 0}}));
  Voxels way;
  for (int x = -10; x <= 0; ++x) way.insert({x, 0, 0});
  EXPECT_EQ(seen.miss, way);
}

TEST(ScanRays, APointBeyondTheLongestRayOnlyClears) {
  const Seen seen = cast({{80.0f, 0.2f, 0.2f}}, {}, {0.2, 0.2, 0.2}, 10.0);
  EXPECT_TRUE(seen.hit.empty());
  EXPECT_EQ(seen.miss.size(), 20u);
  EXPECT_EQ(seen.miss.rbegin()->x(), 19);
}

TEST(ScanRays, APointWinsOverTheRaysThatPass) {
  const Seen seen = cast({{9.2f, 0.2f, 0.2f}, {4.2f, 0.2f, 0.2f}});
  EXPECT_EQ(seen.hit, (Voxels{{18, 0, 0}, {8, 0, 0}}));
  EXPECT_EQ(seen.miss.count({8, 0, 0}), 0u);
  EXPECT_EQ(seen.miss.count({12, 0, 0}), 1u);
}

TEST(ScanRays, EveryRayIsClearInSamplesTakenAlongIt) {
  RandomNumbers random(1);
  const Points points = random.cloud(2000, 20.0);
  const Pose T = random.pose(50.0);
  const Eigen::Vector3d sensor(1, 2, 3);
  const Seen seen = cast(points, T, sensor, 100.0);
  std::size_t samples = 0, passed = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>();
    EXPECT_EQ(seen.hit.count(voxelAround(T * p)), 1u);
    for (double s = 0.0; s < 1.0; s += 0.01) {
      const Voxel voxel = voxelAround(T * Eigen::Vector3d(sensor + s * (p - sensor)));
      passed += seen.hit.count(voxel) + seen.miss.count(voxel);
      ++samples;
    }
  }
  // Rays are not followed where others joined them on the way to the sensor.
  EXPECT_GT(static_cast<double>(passed), 0.95 * static_cast<double>(samples));
}

TEST(ScanRays, KnowsNothingOfTheScanBefore) {
  ScanRays rays(0.5, 30.0);
  rays.cast({{5, 5, 5}}, {}, {0, 0, 0});
  std::size_t hits = 0;
  for (const ScanRaysBlock& block : rays.cast({{-5, 5, 5}}, {}, {0, 0, 0}))
    block.hit.forEach([&](int) { ++hits; });
  EXPECT_EQ(hits, 1u);
}

}  // namespace
}  // namespace revisit_slam
