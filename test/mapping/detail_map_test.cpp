// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/detail_map.h"

#include <gtest/gtest.h>

#include "revisit_slam/mapping/point_map.h"
#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

const Points kPoints{{1.05f, 2.05f, 3.05f}, {-1.05f, 2.05f, 3.05f}, {1.06f, 2.06f, 3.06f}};

TEST(DetailMap, HasThePointsOfAPointMap) {
  RandomNumbers random(1);
  DetailMap detail(0.4);
  PointMap map(0.4);
  for (int scan = 0; scan < 10; ++scan) {
    const Points points = random.cloud(500, 5.0);
    const Pose T = random.pose(3.0);
    detail.insert(points, T, {0.0, 0.0, 1.5});
    map.insert(points, T);
  }
  EXPECT_EQ(detail.points(), map.points());
  ASSERT_EQ(detail.sightings().groups.size(), 10u);
  EXPECT_EQ(detail.sightings().groups.back().end, map.points().size());
  EXPECT_EQ(detail.sightings().lasted.size(), map.points().size());
}

TEST(DetailMap, KnowsTheScanThatSawAPointFirstAndTheOneThatSawItLast) {
  DetailMap map(0.1);
  map.insert({kPoints[1]}, {}, {0.0, 0.0, 1.5});
  map.insert({}, {}, {0.0, 0.0, 1.5});
  map.insert(kPoints, {}, {0.0, 0.0, 1.5});
  map.insert({kPoints[2]}, {}, {0.0, 0.0, 1.5});
  EXPECT_EQ(map.points(), (Points{kPoints[1], kPoints[0]}));
  const Sightings& sightings = map.sightings();
  ASSERT_EQ(sightings.groups.size(), 2u);
  EXPECT_EQ(sightings.groups[0].scan, 0u);
  EXPECT_EQ(sightings.groups[1].scan, 2u);
  EXPECT_EQ(sightings.groups[1].end, 2u);
  EXPECT_EQ(sightings.groups[1].sensor_base, Eigen::Vector3f(0.0f, 0.0f, 1.5f));
  EXPECT_EQ(sightings.lasted, (std::vector<std::uint16_t>{2, 1}));
}

TEST(DetailMap, KnowsWhichSensorSawAPoint) {
  DetailMap map(0.1);
  const Eigen::Vector3d front(1.0, 0.0, 0.5), rear(-1.0, 0.0, 0.5);
  map.insert(kPoints, {}, front, {{front, 1}, {rear, 3}});
  const Sightings& sightings = map.sightings();
  ASSERT_EQ(sightings.groups.size(), 2u);
  EXPECT_EQ(sightings.groups[0].sensor_base, front.cast<float>());
  EXPECT_EQ(sightings.groups[0].end, 1u);
  EXPECT_EQ(sightings.groups[1].sensor_base, rear.cast<float>());
  EXPECT_EQ(sightings.groups[1].end, 2u);
}

TEST(DetailMap, APointHasTheIntensityWithWhichItWasSeenFirst) {
  DetailMap map(0.1);
  map.insert({kPoints[1]}, {}, {0.0, 0.0, 1.5});  // without
  EXPECT_TRUE(map.intensities().empty());
  map.insert(kPoints, {}, {0.0, 0.0, 1.5}, {}, {7.0f, 8.0f, 9.0f});
  EXPECT_EQ(map.points(), (Points{kPoints[1], kPoints[0]}));
  EXPECT_EQ(map.intensities(), (std::vector<float>{0.0f, 7.0f}));
  map.insert({{5.0f, 5.0f, 5.0f}}, {}, {0.0, 0.0, 1.5});
  EXPECT_EQ(map.intensities(), (std::vector<float>{0.0f, 7.0f, 0.0f}));
}

TEST(DetailMap, ASensorWithoutPointsSawNone) {
  DetailMap map(0.1);
  const Eigen::Vector3d blind(5.0, 0.0, 0.5), front(1.0, 0.0, 0.5);
  map.insert(kPoints, {}, front, {{blind, 0}, {front, 3}, {blind, 3}});
  const Sightings& sightings = map.sightings();
  ASSERT_EQ(sightings.groups.size(), 1u);
  EXPECT_EQ(sightings.groups[0].sensor_base, front.cast<float>());
  EXPECT_EQ(sightings.groups[0].end, 2u);
}

}  // namespace
}  // namespace revisit_slam
