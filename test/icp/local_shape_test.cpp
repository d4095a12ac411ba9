// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/local_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

constexpr float kEdge = 1.0f;

LocalShape of(const Points& points) {
  PointMoments moments;
  for (const Eigen::Vector3f& point : points) moments.add(point);
  return localShapeOf(moments, kEdge);
}

/// On the ground, tilted, from `first` to `last` in direction, at a distance with play.
Points arc(double radius, double first, double last, int count, RandomNumbers& random) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double angle = first + (last - first) * i / count;
    const Eigen::Vector3d p(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    points.push_back((p + random.gaussian(0.01) * Eigen::Vector3d::UnitZ()).cast<float>());
  }
  return points;
}

TEST(LocalShape, APlaneHasANormal) {
  RandomNumbers random(1);
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  Points points;
  for (int i = 0; i < 60; ++i)
    points.push_back((tilt * Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1),
                                             random.gaussian(0.02)))
                         .cast<float>());
  const LocalShape shape = of(points);
  EXPECT_EQ(shape.kind, ShapeKind::planar);
  const Eigen::Vector3d normal = tilt * Eigen::Vector3d::UnitZ();
  EXPECT_GT(std::abs(shape.normal.cast<double>().dot(normal)), 0.999);
}

TEST(LocalShape, ASingleRingIsSparseAndTwoMakeAPlane) {
  RandomNumbers random(2);
  Points points = arc(10.0, 0.0, 0.25, 40, random);
  EXPECT_EQ(of(points).kind, ShapeKind::sparse);
  for (const auto& point : arc(11.0, 0.0, 0.25, 40, random)) points.push_back(point);
  EXPECT_EQ(of(points).kind, ShapeKind::planar);
  EXPECT_GT(std::abs(of(points).normal.z()), 0.99f);
}

TEST(LocalShape, APoleIsNoRing) {
  Points upright, level;
  for (int i = 0; i < 20; ++i) {
    upright.push_back({0.1f, 0.2f, 0.1f * static_cast<float>(i)});
    level.push_back({0.1f * static_cast<float>(i), 0.2f, 0.3f});
  }
  EXPECT_EQ(of(upright).kind, ShapeKind::scattered);
  EXPECT_EQ(of(level).kind, ShapeKind::sparse);
}

TEST(LocalShape, FewPointsAreSparseAndABushIsScattered) {
  RandomNumbers random(3);
  Points points;
  for (int i = 0; i < 5; ++i) points.push_back(random.direction().cast<float>());
  EXPECT_EQ(of(points).kind, ShapeKind::sparse);
  EXPECT_EQ(of({}).kind, ShapeKind::sparse);
  for (int i = 0; i < 60; ++i) points.push_back(random.direction().cast<float>());
  EXPECT_EQ(of(points).kind, ShapeKind::scattered);
  EXPECT_TRUE(of(points).normal.isZero());
  EXPECT_EQ(of(points).points, 65.0f);
}

PointMoments momentsOf(const Points& points) {
  PointMoments moments;
  for (const Eigen::Vector3f& point : points) moments.add(point);
  return moments;
}

LocalShape withFarther(const Points& near, Points farther) {
  farther.insert(farther.end(), near.begin(), near.end());
  return widenedShapeOf(of(near), momentsOf(near), momentsOf(farther), kEdge);
}

/// Rings on the ground and columns on a wall beside the road.
TEST(LocalShape, ALineOnAPlaneThatIsSeenFartherAroundIsPlanar) {
  RandomNumbers random(5);
  const Points ring = arc(10.0, -0.12, 0.12, 20, random);
  const LocalShape ground = withFarther(ring, arc(13.0, -0.12, 0.12, 20, random));
  EXPECT_EQ(ground.kind, ShapeKind::planar);
  EXPECT_GT(std::abs(ground.normal.z()), 0.99f);
  EXPECT_EQ(ground.points, 20.0f);
  Points column, next_column;
  for (int i = 0; i < 12; ++i) {
    column.push_back({0.0f, 5.0f, 0.15f * static_cast<float>(i)});
    next_column.push_back({2.0f, 5.0f, 0.15f * static_cast<float>(i)});
  }
  EXPECT_EQ(of(column).kind, ShapeKind::scattered);
  const LocalShape wall = withFarther(column, next_column);
  EXPECT_EQ(wall.kind, ShapeKind::planar);
  EXPECT_GT(std::abs(wall.normal.y()), 0.99f);
}

TEST(LocalShape, ALineThatNoPlaneIsSeenAroundStaysOne) {
  RandomNumbers random(6);
  const Points ring = arc(10.0, -0.12, 0.12, 20, random);
  EXPECT_EQ(withFarther(ring, {}).kind, ShapeKind::sparse) << "nothing else";
  Points bush;
  for (int i = 0; i < 60; ++i) bush.push_back((ring[10] + 2.0f * random.direction().cast<float>()));
  EXPECT_EQ(withFarther(ring, bush).kind, ShapeKind::sparse) << "among scattered points";
  Points pole, ground;
  for (int i = 0; i < 12; ++i) pole.push_back({10.0f, 0.0f, 0.15f * static_cast<float>(i)});
  for (const double radius : {8.0, 9.0, 11.0, 12.0})
    for (const Eigen::Vector3f& point : arc(radius, -0.2, 0.2, 40, random)) ground.push_back(point);
  EXPECT_EQ(withFarther(pole, ground).kind, ShapeKind::scattered) << "a pole stands on a plane";
  Points bar;  // too few to thicken the plane
  for (int i = 8; i < 12; ++i) bar.push_back(ring[i] + Eigen::Vector3f(0, 0, 0.5f));
  EXPECT_EQ(withFarther(bar, ground).kind, ShapeKind::sparse) << "above a plane";
}

TEST(PointMoments, AreThoseOfTheSamePointsFromAnotherOrigin) {
  RandomNumbers random(4);
  const Eigen::Vector3f shift(1.0f, -2.0f, 1.0f);
  PointMoments here, there, added;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3f point = random.direction().cast<float>();
    there.add(point);
    here.add(point + shift);
  }
  added.add(there, shift);
  EXPECT_EQ(added.count, here.count);
  EXPECT_LT((added.sum - here.sum).norm(), 1e-4f);
  EXPECT_LT((added.squares - here.squares).norm(), 1e-3f);
}

}  // namespace
}  // namespace revisit_slam
