// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/normals.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

/// Means of a 20 x 20 m plane through `centre` with 2 cm noise.
VoxelMeans plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& centre) {
  RandomNumbers random(3);
  const Eigen::Quaterniond R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
  Points points;
  for (int i = 0; i < 20000; ++i)
    points.push_back((centre + R * Eigen::Vector3d(random.uniform(-10, 10), random.uniform(-10, 10),
                                                   random.gaussian(0.02)))
                         .cast<float>());
  VoxelMeanGrid grid(0.5);
  grid.insert(points);
  return grid.take();
}

TEST(Normals, OfAPlaneAreItsNormalTowardsTheOrigin) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 3).normalized();
  const VoxelMeans means = plane(normal, -15.0 * normal);
  const Points normals = estimateNormals(means);
  std::size_t with_normal = 0;
  for (const Eigen::Vector3f& n : normals) {
    if (n.isZero()) continue;
    ++with_normal;
    EXPECT_GT(n.dot(normal.cast<float>()), std::cos(6.0 * M_PI / 180.0));
  }
  EXPECT_GT(with_normal, 0.95 * static_cast<double>(normals.size()));
}

TEST(Normals, OfAPoleAreZero) {
  VoxelMeanGrid grid(0.5);
  for (int i = 0; i < 100; ++i) grid.insert({{5.1f, 5.1f, 0.1f * static_cast<float>(i)}});
  for (const Eigen::Vector3f& n : estimateNormals(grid.take())) EXPECT_TRUE(n.isZero());
}

TEST(Normals, DoNotDependOnThreads) {
  const VoxelMeans means = plane(Eigen::Vector3d(1, 1, 5).normalized(), {3, 4, 5});
  Points one, four;
  tbb::task_arena(1).execute([&] { one = estimateNormals(means); });
  tbb::task_arena(4).execute([&] { four = estimateNormals(means); });
  EXPECT_EQ(one, four);
}

}  // namespace
}  // namespace revisit_slam
