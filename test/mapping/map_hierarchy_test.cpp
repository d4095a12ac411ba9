// SPDX-License-Identifier: MIT
#include "revisit_slam/mapping/map_hierarchy.h"

#include <gtest/gtest.h>

#include "support/random_numbers.h"

namespace revisit_slam {
namespace {

struct Closed {
  std::vector<SubmapPtr> submaps;
  std::vector<LocalMapPtr> local_maps;

  void add(const ClosedMaps& maps) {
    if (maps.submap) submaps.push_back(maps.submap);
    if (maps.local_map) local_maps.push_back(maps.local_map);
  }
};

/// One point per scan, 5 m to the left.
Closed mapsOf(const std::vector<Pose>& T_odom_scan) {
  MapHierarchy hierarchy{MappingConfig{}};
  Closed closed;
  for (unsigned i = 0; i < T_odom_scan.size(); ++i)
    closed.add(hierarchy.insert({i}, Stamp{i}, T_odom_scan[i], {{0, 5, 0}}));
  closed.add(hierarchy.closeAll());
  EXPECT_EQ(hierarchy.closeAll().submap, nullptr);
  EXPECT_EQ(hierarchy.closeAll().local_map, nullptr);
  return closed;
}

std::vector<Pose> straight(int metres) {
  std::vector<Pose> poses;
  for (int x = 0; x <= metres; ++x)
    poses.push_back({expSO3({0, 0, 0.3}), {static_cast<double>(x), 0, 0}});
  return poses;
}

TEST(MapHierarchy, SplitsByDisplacement) {
  const Closed closed = mapsOf(straight(230));
  // 26 scans are within 25 m of the first; the local map ends 100 m after its own first.
  std::vector<unsigned> firsts;
  for (const SubmapPtr& submap : closed.submaps) firsts.push_back(submap->first_scan.value);
  EXPECT_EQ(firsts, (std::vector<unsigned>{0, 26, 52, 78, 101, 127, 153, 179, 202, 228}));
  ASSERT_EQ(closed.local_maps.size(), 3u);
  EXPECT_EQ(closed.local_maps[1]->submaps.front()->first_scan.value, 101u);
}

TEST(MapHierarchy, NoMapGoesOnWhereTheTrackIsLost) {
  MapHierarchy hierarchy{MappingConfig{}};
  Closed closed;
  for (unsigned i = 0; i < 20; ++i) {
    SubmapStart start;
    start.after_loss = i == 7;
    closed.add(hierarchy.insert({i}, Stamp{i}, straight(20)[i], {{0, 5, 0}}, start));
  }
  closed.add(hierarchy.closeAll());
  ASSERT_EQ(closed.local_maps.size(), 2u);
  EXPECT_EQ(closed.local_maps[0]->submaps.back()->lastScan().value, 6u);
  EXPECT_FALSE(closed.local_maps[0]->after_loss);
  EXPECT_EQ(closed.local_maps[1]->submaps.front()->first_scan.value, 7u);
  EXPECT_TRUE(closed.local_maps[1]->after_loss);
}

TEST(MapHierarchy, SubmapsKnowHowFarTheOdometryHadCome) {
  for (const SubmapPtr& submap : mapsOf(straight(230)).submaps) {
    EXPECT_NEAR(submap->travelled_begin, submap->first_scan.value, 1e-9);
    EXPECT_NEAR(submap->travelled_end, submap->lastScan().value, 1e-9);
  }
}

TEST(MapHierarchy, EverySubmapBelongsToTheLocalMapThatHoldsIt) {
  const Closed closed = mapsOf(straight(230));
  unsigned id = 0, scan = 0;
  for (unsigned n = 0; n < closed.local_maps.size(); ++n) {
    EXPECT_EQ(closed.local_maps[n]->id.value, n);
    for (const SubmapPtr& submap : closed.local_maps[n]->submaps) {
      EXPECT_EQ(submap, closed.submaps[id]);
      EXPECT_EQ(submap->id.value, id++);
      EXPECT_EQ(submap->local_map.value, n);
      EXPECT_EQ(submap->first_scan.value, scan);
      EXPECT_EQ(submap->stamps.front().nanoseconds, scan);
      EXPECT_EQ(submap->stamps.size(), submap->T_submap_scan.size());
      scan = submap->lastScan().value + 1;
    }
  }
  EXPECT_EQ(scan, 231u);
}

TEST(MapHierarchy, PosesAndPointsAreRelativeToTheKeypose) {
  const std::vector<Pose> poses = straight(60);
  const Closed closed = mapsOf(poses);
  const Submap& submap = *closed.submaps[1];
  EXPECT_EQ(submap.T_submap_scan[0].translation, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < submap.T_submap_scan.size(); ++i)
    EXPECT_LT(distanceBetween(submap.T_odom_submap * submap.T_submap_scan[i],
                              poses[submap.first_scan.value + i]),
              1e-9);
  EXPECT_EQ(submap.points.size(), submap.normals.size());
  for (const Eigen::Vector3f& p : submap.points) {
    const Eigen::Vector3d p_odom = submap.T_odom_submap * Eigen::Vector3d(p.cast<double>());
    EXPECT_NEAR(p_odom.y(), 5 * std::cos(0.3), 1e-4);  // on the line of points beside the road
  }
}

TEST(MapHierarchy, LocalMapIsTheUnionOfItsSubmaps) {
  const Closed closed = mapsOf(straight(60));
  const LocalMap& local_map = *closed.local_maps[0];
  EXPECT_NEAR(static_cast<double>(local_map.points.size()), 61.0, 3.0);
  for (const Eigen::Vector3f& p : local_map.points) {
    const Eigen::Vector3d p_odom = local_map.T_odom_local() * Eigen::Vector3d(p.cast<double>());
    EXPECT_NEAR(p_odom.y(), 5 * std::cos(0.3), 1e-4);
  }
}

TEST(MapHierarchy, WalksInCirclesEndByThePathLength) {
  std::vector<Pose> poses;
  for (int i = 0; i < 450; ++i)
    poses.push_back({expSO3({0, 0, 0.2 * i}), {5 * std::cos(0.2 * i), 5 * std::sin(0.2 * i), 0}});
  const Closed closed = mapsOf(poses);  // chords of just below 1 m
  ASSERT_EQ(closed.local_maps.size(), 3u);
  EXPECT_EQ(closed.submaps[0]->stamps.size(), 51u);
  EXPECT_EQ(closed.local_maps[0]->submaps.size(), 4u);
}

TEST(MapHierarchy, ARobotThatStandsKeepsOneSubmap) {
  const Closed closed = mapsOf(std::vector<Pose>(1000));
  ASSERT_EQ(closed.submaps.size(), 1u);
  EXPECT_EQ(closed.submaps[0]->points.size(), 1u);
}

TEST(MapHierarchy, InNarrowSurroundingsMapsAreSmaller) {
  MapHierarchy hierarchy{MappingConfig{}};
  Closed closed;
  const std::vector<Pose> poses = straight(60);
  for (unsigned i = 0; i < poses.size(); ++i) {
    const Points points{{0, 5, 0}, {0.3f, 5, 0}};
    closed.add(hierarchy.insert({i}, Stamp{i}, poses[i], points, {0.25, 0.25, {}, {}}));
  }
  std::vector<unsigned> firsts;
  for (const SubmapPtr& submap : closed.submaps) {
    firsts.push_back(submap->first_scan.value);
    EXPECT_EQ(submap->scale, 0.25);
  }
  EXPECT_EQ(firsts, (std::vector<unsigned>{0, 7, 14, 21, 26, 33, 40, 47, 52}));
  EXPECT_EQ(closed.local_maps.size(), 2u);
  EXPECT_GE(closed.submaps[0]->points.size(), 14u);  // voxels of 0.125 m keep the two points apart
}

TEST(MapHierarchy, SubmapsKnowHowUnsureTheOdometryWasAtTheirFirstScan) {
  MapHierarchy hierarchy{MappingConfig{}};
  Closed closed;
  const std::vector<Pose> poses = straight(60);
  for (unsigned i = 0; i < poses.size(); ++i)
    closed.add(
        hierarchy.insert({i}, Stamp{i}, poses[i], {}, {1.0, 1.0, {1.0 * i, 3.0 * i, 2.0 * i}, {}}));
  ASSERT_GE(closed.submaps.size(), 2u);
  EXPECT_EQ(closed.submaps[1]->unsure_begin.weak, 26.0);
  EXPECT_EQ(closed.submaps[1]->unsure_begin.weak_height, 78.0);
  EXPECT_EQ(closed.submaps[1]->unsure_begin.doubt, 52.0);
}

TEST(MapHierarchy, NormalsAreOnTheSideThatWasSeen) {
  MapHierarchy hierarchy{MappingConfig{}};
  Points slab;  // 1 m above the base, 1 m below the sensor
  for (float x = -3.0f; x <= 3.0f; x += 0.2f)
    for (float y = -3.0f; y <= 3.0f; y += 0.2f) slab.emplace_back(x, y, 1.0f);
  SubmapStart start;
  start.sensor_base = {0, 0, 2.0};
  hierarchy.insert({0}, {}, {}, slab, start);
  const SubmapPtr above = hierarchy.closeAll().submap;
  hierarchy.insert({1}, {}, {}, slab);
  const SubmapPtr below = hierarchy.closeAll().submap;
  std::size_t known = 0;
  for (std::size_t i = 0; i < above->normals.size(); ++i) {
    EXPECT_GE(above->normals[i].z(), 0.0f);
    EXPECT_LE(below->normals[i].z(), 0.0f);
    known += above->normals[i].z() > 0.9f && below->normals[i].z() < -0.9f;
  }
  EXPECT_GT(known, above->points.size() * 9 / 10);
}

TEST(MapHierarchy, GoesOnAfterClosingOnRequest) {
  MapHierarchy hierarchy{MappingConfig{}};
  hierarchy.insert({0}, {}, {}, {});
  const ClosedMaps closed = hierarchy.closeAll();
  ASSERT_NE(closed.submap, nullptr);
  EXPECT_TRUE(closed.submap->points.empty());
  hierarchy.insert({1}, {}, {}, {});
  const ClosedMaps next = hierarchy.closeAll();
  EXPECT_EQ(next.submap->id.value, 1u);
  EXPECT_EQ(next.local_map->id.value, 1u);
  EXPECT_EQ(next.submap->first_scan.value, 1u);
}

}  // namespace
}  // namespace revisit_slam
