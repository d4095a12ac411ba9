// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "revisit_slam/icp/local_voxel_map.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

Pose at(const Eigen::Vector3d& translation) {
  return {Eigen::Quaterniond::Identity(), translation};
}

Eigen::Vector3d voxelIn(const Eigen::Vector3d& point, double voxel_size) {
  return (point / voxel_size).array().floor();
}

/// Voxel size and centre of the clouds.
class Nearest : public ::testing::TestWithParam<std::pair<double, Eigen::Vector3d>> {};

TEST_P(Nearest, IsTheNearestPointOfTheTwentySevenVoxels) {
  const auto [voxel_size, centre] = GetParam();
  RandomNumbers random(1);
  int found = 0, missed = 0, rivals_seen = 0;
  for (const std::size_t count : {1u, 60u, 2000u}) {
    LocalVoxelMap map({voxel_size, 20});
    map.insert(random.cloud(count, 4.0 * voxel_size), at(centre));
    const Points near_centre = map.points(at(-centre));  // float is exact enough only there
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d query = centre + random.inCube(5.0 * voxel_size);
      const double max_distance = voxel_size * random.uniform(0.05, 3.0);
      double nearest = max_distance, first = 1e9, second = 1e9;
      for (const Eigen::Vector3f& point : near_centre) {
        const Eigen::Vector3d p = point.cast<double>() + centre;
        const double distance = (p - query).norm();
        second = std::min(second, std::max(first, distance));
        first = std::min(first, distance);
        const Eigen::Array3d steps = voxelIn(p, voxel_size) - voxelIn(query, voxel_size);
        if (steps.abs().maxCoeff() <= 1.0) nearest = std::min(nearest, distance);
      }
      Neighbour neighbour;
      const bool expected = nearest < max_distance;
      ASSERT_EQ(map.nearest(query, max_distance, neighbour), expected);
      ++(expected ? found : missed);
      if (!expected) continue;
      const double tolerance = 1e-5 * voxel_size;
      EXPECT_NEAR(neighbour.distance, nearest, tolerance);
      EXPECT_NEAR((neighbour.point_odom - query).norm(), nearest, tolerance);
      // All other points are at least as far as said: with the nearest of all found, the second.
      const double rival = nearest <= first + tolerance ? second : first;
      EXPECT_LE(neighbour.rival_distance, rival + tolerance);
      EXPECT_GE(neighbour.rival_distance, std::min(nearest, voxel_size) - tolerance);
      rivals_seen += neighbour.rival_distance > nearest + 0.05 * voxel_size;
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(missed, 1000);
  EXPECT_GT(rivals_seen, 300);  // a bound that never leaves room would be true, but no use
}

INSTANTIATE_TEST_SUITE_P(LocalVoxelMap, Nearest,
                         ::testing::Values(std::pair{1.0, Eigen::Vector3d(0, 0, 0)},
                                           std::pair{0.3, Eigen::Vector3d(-51.3, 20.7, -3.1)},
                                           std::pair{0.5, Eigen::Vector3d(10000, -10000, 300)},
                                           std::pair{2.0, Eigen::Vector3d(-10000, 123, -9999)}));

}  // namespace
}  // namespace revisit_slam
