// SPDX-License-Identifier: MIT
#include "revisit_slam/localization/recent_map.h"

#include <gtest/gtest.h>

#include "street_map.h"

namespace revisit_slam {
namespace {

class RecentMapTest : public testing::Test {
 protected:
  void insertAll() {
    for (const InformedScan& scan : scansAlong(drive(0, 60))) {
      recent_.insert(*scan.scan);
      recent_.cut();
    }
  }

  RecentMap recent_{0.5, 30.0};
};

TEST_F(RecentMapTest, TheLastMetresEndWithTheNewestScan) {
  insertAll();
  EXPECT_NEAR(recent_.travelled(), 60.0, 1e-9);
  const Submap submap = recent_.submap(20.0);
  EXPECT_EQ(submap.first_scan, ScanId{12});
  EXPECT_EQ(submap.T_submap_scan.size(), 5u);
  EXPECT_NEAR(submap.T_submap_scan.front().translation.x(), -20.0, 1e-9);
  EXPECT_EQ(submap.T_submap_scan.back().translation.norm(), 0.0);
  EXPECT_EQ(submap.points.size(), submap.normals.size());
  const auto planar = std::count_if(submap.normals.begin(), submap.normals.end(),
                                    [](const auto& normal) { return !normal.isZero(); });
  EXPECT_GT(planar, static_cast<std::ptrdiff_t>(submap.normals.size() / 2));
  EXPECT_GT(recent_.localMap(30.0).points.size(), submap.points.size());
}

TEST_F(RecentMapTest, IsEmptyBeforeTheFirstScan) {
  EXPECT_TRUE(recent_.submap(20.0).points.empty());
  EXPECT_TRUE(recent_.localMap(20.0).points.empty());
}

TEST_F(RecentMapTest, ForgetsWhatIsTooOld) {
  insertAll();
  EXPECT_LE(recent_.kept(), 35.0);
  EXPECT_EQ(recent_.submap(1000.0).T_submap_scan.size(),
            recent_.submap(recent_.kept()).T_submap_scan.size());
}

TEST_F(RecentMapTest, ASubmapIsWhatTheScansAddUpTo) {
  const std::vector<InformedScan> scans = scansAlong(drive(0, 10));
  VoxelMeanGrid grid(0.5);
  for (const InformedScan& scan : scans) {
    recent_.insert(*scan.scan);
    grid.insert(scan.scan->points_base,
                scans.back().scan->T_odom_base.inverse() * scan.scan->T_odom_base);
  }
  recent_.cut();
  // Voxels lie otherwise in the slice's frame: not the same points, but about as many, and near.
  const Points direct = grid.take().points, sliced = recent_.submap(10.0).points;
  EXPECT_NEAR(static_cast<double>(sliced.size()), static_cast<double>(direct.size()),
              0.1 * static_cast<double>(direct.size()));
}

/// The base is on the ground, and the sensor above it.
TEST_F(RecentMapTest, NormalsPointToWhereTheSurfaceWasSeenFrom) {
  for (const InformedScan& informed : scansAlong(drive(0, 20))) {
    RegisteredScan scan = *informed.scan;
    scan.sensor_base = {0.0, 0.0, 1.5};
    for (Eigen::Vector3f& p : scan.points_base) p.z() += 1.5f;
    recent_.insert(scan);
  }
  recent_.cut();
  const Submap submap = recent_.submap(20.0);
  std::size_t ground = 0;
  for (std::size_t i = 0; i < submap.points.size(); ++i) {
    const Eigen::Vector3f& p = submap.points[i];
    const bool is_near = p.x() > -20.0f && p.x() < 0.0f && std::abs(p.y()) < 6.0f;
    if (!is_near || std::abs(p.z()) > 0.1f || std::abs(submap.normals[i].z()) < 0.9f) continue;
    ++ground;
    EXPECT_GT(submap.normals[i].z(), 0.0f) << i;
  }
  EXPECT_GT(ground, 200u);
}

TEST_F(RecentMapTest, FollowsTheSizeOfThePlaceAsTheMapDoes) {
  RecentMap fine{0.5, 30.0, {true, 0.7}};
  for (const InformedScan& informed : scansAlong(drive(0, 20))) {
    RegisteredScan scan = *informed.scan;
    scan.voxel_size = 0.175;
    fine.insert(scan);
    recent_.insert(scan);
  }
  fine.cut();
  recent_.cut();
  EXPECT_EQ(fine.submap(20.0).scale, 0.5);
  EXPECT_EQ(recent_.submap(20.0).scale, 1.0);
  EXPECT_GT(fine.submap(20.0).points.size(), 3 * recent_.submap(20.0).points.size() / 2);
}

}  // namespace
}  // namespace revisit_slam
