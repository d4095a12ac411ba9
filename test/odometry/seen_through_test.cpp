// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/seen_through.h"

#include <gtest/gtest.h>

namespace revisit_slam {
namespace {

/// Across the x axis.
Points wall(float x) {
  Points points;
  for (int y = -20; y <= 20; ++y)
    for (int z = -20; z <= 20; ++z)
      points.emplace_back(x, 0.2f * static_cast<float>(y), 0.2f * static_cast<float>(z));
  return points;
}

class SeenThrough : public testing::Test {
 protected:
  SeenThrough() : map_(LocalVoxelMapConfig{}) { map_.insert(wall(10.0f), Pose::identity()); }

  double share(const Points& points, const Pose& T_odom_base = {}) const {
    return shareSeenThrough(points, Eigen::Vector3d::Zero(), T_odom_base, map_);
  }

  LocalVoxelMap map_;
};

TEST_F(SeenThrough, IsWhatLiesBehindAPlane) {
  EXPECT_GT(share(wall(20.0f)), 0.9);
  Points half = wall(20.0f), beside = wall(20.0f);
  for (Eigen::Vector3f& point : beside) point.x() = -20.0f;
  half.insert(half.end(), beside.begin(), beside.end());
  EXPECT_NEAR(share(half), 0.5 * share(wall(20.0f)), 0.02);
}

TEST_F(SeenThrough, IsNotThePlaneItselfNorWhatStandsBeforeIt) {
  EXPECT_EQ(share(wall(10.0f)), 0.0);
  EXPECT_EQ(share(wall(10.5f)), 0.0);
  EXPECT_EQ(share(wall(5.0f)), 0.0);
}

TEST_F(SeenThrough, FollowsThePose) {
  const Pose behind{Eigen::Quaterniond::Identity(), {12.0, 0.0, 0.0}};
  EXPECT_EQ(share(wall(20.0f), behind), 0.0);
}

TEST_F(SeenThrough, NothingIsWithoutPointsOrMap) {
  EXPECT_EQ(share({}), 0.0);
  EXPECT_EQ(shareSeenThrough(wall(20.0f), Eigen::Vector3d::Zero(), {},
                             LocalVoxelMap(LocalVoxelMapConfig{})),
            0.0);
}

}  // namespace
}  // namespace revisit_slam
