// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/local_voxel_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

Pose at(const Eigen::Vector3d& translation) {
  return {Eigen::Quaterniond::Identity(), translation};
}

Points sorted(Points points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  return points;
}

Eigen::Vector3d voxelIn(const Eigen::Vector3d& point, double voxel_size) {
  return (point / voxel_size).array().floor();
}

TEST(LocalVoxelMap, IsEmptyAtFirst) {
  const LocalVoxelMap map({});
  Neighbour neighbour;
  EXPECT_TRUE(map.empty());
  EXPECT_TRUE(map.points().empty());
  EXPECT_FALSE(map.nearest({0, 0, 0}, 100.0, neighbour));
}

/// The rule of insertion, written plainly.
Points insertedByRule(const Points& input, const LocalVoxelMapConfig& config) {
  const float spacing =
      static_cast<float>(config.voxel_size / std::sqrt(config.max_points_per_voxel));
  Points kept;
  for (const Eigen::Vector3f& point : input) {
    int in_voxel = 0;
    bool far_enough = true;
    for (const Eigen::Vector3f& other : kept) {
      if (voxelIn(other.cast<double>(), config.voxel_size) !=
          voxelIn(point.cast<double>(), config.voxel_size))
        continue;
      ++in_voxel;
      far_enough = far_enough && (point - other).norm() >= spacing;
    }
    if (in_voxel < config.max_points_per_voxel && far_enough) kept.push_back(point);
  }
  return kept;
}

TEST(LocalVoxelMap, TakesPointsThatKeepTheirDistanceWhileAVoxelHasRoom) {
  for (const int capacity : {1, 3, 20, 100}) {
    RandomNumbers random(2);
    const LocalVoxelMapConfig config{1.0, capacity};
    LocalVoxelMap map(config);
    Points input = random.cloud(3000, 1.5);
    for (auto& point : input) point = (1024.0f * point).array().round() / 1024.0f;  // exact floats
    map.insert({input.begin(), input.begin() + 1000}, {});
    map.insert({input.begin() + 1000, input.end()}, {});
    EXPECT_EQ(sorted(map.points()), sorted(insertedByRule(input, config))) << capacity;
    EXPECT_EQ(map.voxels(), 64u);
  }
}

TEST(LocalVoxelMap, PlacesPointsWithThePoseAndGivesThemInAnyFrame) {
  RandomNumbers random(3);
  const Pose T = random.pose(50.0);
  LocalVoxelMap map({1.0, 20});
  const Points input{{0.2f, 0.3f, 0.4f}, {5, 6, 7}, {-5, 3, -1}};
  map.insert(input, T);
  const Points back = map.points(T.inverse());
  ASSERT_EQ(back.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT((back[i] - input[i]).norm(), 1e-5f);
}

TEST(LocalVoxelMap, DropsVoxelsWhoseCentreIsTooFarAndUsesTheirPlaceAgain) {
  RandomNumbers random(4);
  constexpr double voxel_size = 0.5;
  for (const Eigen::Vector3d& centre :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9000, -7000, 50)}) {
    LocalVoxelMap map({voxel_size, 20});
    const Points cloud = random.cloud(5000, 8.0);
    map.insert(cloud, at(centre));
    const Eigen::Vector3d dropped_around = centre + Eigen::Vector3d(3, -1, 2);
    Points expected;
    for (const Eigen::Vector3f& point : map.points(at(-centre))) {
      const Eigen::Array3d voxel = voxelIn(point.cast<double>() + centre, voxel_size);
      const Eigen::Vector3d voxel_centre = voxel_size * (voxel + 0.5);
      if ((voxel_centre - dropped_around).norm() <= 6.1) expected.push_back(point);
    }
    map.dropBeyond(dropped_around, 6.1);
    EXPECT_EQ(sorted(map.points(at(-centre))), sorted(expected));
    EXPECT_GT(expected.size(), 1000u);

    LocalVoxelMap fresh({voxel_size, 20});  // filled anew, a used map is as good as a new one
    map.dropBeyond(centre + Eigen::Vector3d(0, 0, 1000), 1.0);
    EXPECT_TRUE(map.empty());
    EXPECT_TRUE(map.points().empty());
    const Points next = random.cloud(5000, 8.0);
    map.insert(next, at(centre));
    fresh.insert(next, at(centre));
    EXPECT_EQ(map.voxels(), fresh.voxels());
    EXPECT_EQ(sorted(map.points(at(-centre))), sorted(fresh.points(at(-centre))));
  }
}

/// Of the points of the map in the voxel of `point` and around it.
LocalShape shapeByRule(const Points& points, const Eigen::Vector3d& point) {
  PointMoments around;
  for (const Eigen::Vector3f& other : points)
    if ((voxelIn(other.cast<double>(), 1.0) - voxelIn(point, 1.0)).cwiseAbs().maxCoeff() <= 1.0)
      around.add(other - point.cast<float>());
  return localShapeOf(around, 1.0f);
}

TEST(LocalVoxelMap, KnowsWhatSurroundsANeighbour) {
  RandomNumbers random(7);
  Points ground;
  for (int i = 0; i < 6000; ++i)
    ground.push_back({static_cast<float>(random.uniform(-8, 8)),
                      static_cast<float>(random.uniform(-8, 8)),
                      static_cast<float>(0.5 + random.gaussian(0.01))});
  Points bush;
  for (int i = 0; i < 3000; ++i)
    bush.push_back((20.0 * Eigen::Vector3d::UnitX() + 1.5 * random.direction()).cast<float>());
  LocalVoxelMap map({1.0, 20});
  map.insert(ground, {});
  map.insert(bush, {});
  int planar = 0, scattered = 0;
  for (const Eigen::Vector3d& query : {Eigen::Vector3d(0.3, 0.2, 0.6), Eigen::Vector3d(4, -3, 0.4),
                                       Eigen::Vector3d(21.4, 0, 0), Eigen::Vector3d(20, 1, 1)}) {
    Neighbour neighbour;
    ASSERT_TRUE(map.nearest(query, 1.0, neighbour));
    const LocalShape expected = shapeByRule(map.points(), neighbour.point_odom);
    EXPECT_EQ(neighbour.shape.kind, expected.kind);
    EXPECT_EQ(neighbour.shape.points, expected.points);
    EXPECT_GE(std::abs(neighbour.shape.normal.dot(expected.normal)),
              expected.normal.squaredNorm() - 1e-3f);
    planar += expected.kind == ShapeKind::planar;
    scattered += expected.kind == ShapeKind::scattered;
  }
  EXPECT_EQ(planar, 2);
  EXPECT_EQ(scattered, 2);
}

/// As a sensor draws them on level ground far ahead, farther apart than the 27 voxels reach.
TEST(LocalVoxelMap, TellsTheGroundFromRingsThatAreFarApart) {
  Points near, far;
  for (int i = 0; i < 60; ++i) {
    const float y = 0.1f * static_cast<float>(i) - 3.0f;
    near.push_back({21.5f, y, 0.1f});
    far.push_back({24.0f, y, 0.1f});
  }
  LocalVoxelMap map({1.0, 20});
  map.insert(near, {});
  Neighbour neighbour;
  ASSERT_TRUE(map.nearest({21.4, 0.0, 0.0}, 1.0, neighbour));
  EXPECT_EQ(neighbour.shape.kind, ShapeKind::sparse);
  map.insert(far, {});
  ASSERT_TRUE(map.nearest({23.9, 0.0, 0.0}, 1.0, neighbour));
  EXPECT_EQ(neighbour.shape.kind, ShapeKind::planar);
  EXPECT_GT(neighbour.shape.normal.cwiseAbs().z(), 0.999f);
  map.dropBeyond({100.0, 0.0, 0.0}, 50.0);
  map.insert(far, {});
  ASSERT_TRUE(map.nearest({23.9, 0.0, 0.0}, 1.0, neighbour));
  EXPECT_EQ(neighbour.shape.kind, ShapeKind::sparse) << "what was dropped tells nothing";
}

TEST(LocalVoxelMap, HoldsTheSamePointsWithoutTheirShapes) {
  RandomNumbers random(8);
  LocalVoxelMap with({1.0, 20}), without({1.0, 20}, false);
  const Points points = random.cloud(5000, 8.0);
  with.insert(points, {});
  without.insert(points, {});
  EXPECT_EQ(with.points(), without.points());
  Neighbour neighbour;
  ASSERT_TRUE(without.nearest(points[0].cast<double>(), 1.0, neighbour));
  EXPECT_EQ(neighbour.shape.points, 0.0f);
  ASSERT_TRUE(with.nearest(points[0].cast<double>(), 1.0, neighbour));
  EXPECT_GT(neighbour.shape.points, 0.0f);
}

}  // namespace
}  // namespace revisit_slam
