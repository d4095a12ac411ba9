// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/occupancy_messages.h"

#include <gtest/gtest.h>

#include "revisit_slam/occupancy/occupancy_builder.h"
#include "revisit_slam/occupancy/occupancy_map.h"
#ifdef REVISIT_SLAM_OCTOMAP_MSGS
#include <octomap_msgs/conversions.h>

#include "revisit_slam/occupancy/octree.h"
#endif

namespace revisit_slam {
namespace {

/// A wall at x = 5, seen from the origin.
OccupancyVoxels mapOfWall(const OccupancyConfig& config) {
  OccupancyBuilder builder(config);
  Points wall;
  for (float y = -2.0f; y <= 2.0f; y += 0.1f)
    for (float z = 0.0f; z <= 2.0f; z += 0.1f) wall.push_back({5.2f, y, z});
  builder.insert(wall, Pose::identity(), {0.0, 0.0, 1.0});
  OccupancyMap map(config);
  map.place(SubmapId{0}, builder.close(), Pose::identity());
  map.compose();
  return map.voxels();
}

TEST(OccupancyMessages, CubesStandWhereTheWallIs) {
  const OccupancyVoxels map = mapOfWall({});
  const auto array = toVoxelMarkers(map, Stamp::fromSeconds(12.5), "map");
  ASSERT_EQ(array.markers.size(), 1u);
  const auto& marker = array.markers[0];
  EXPECT_EQ(marker.header.frame_id, "map");
  EXPECT_EQ(marker.header.stamp, ros::Time(12, 500000000));
  EXPECT_EQ(marker.action, marker.ADD);
  EXPECT_EQ(marker.scale.x, map.resolution);
  ASSERT_GT(marker.points.size(), 20u);
  EXPECT_EQ(marker.points.size(), marker.colors.size());
  for (const auto& point : marker.points) EXPECT_NEAR(point.x, 5.25, 0.26);
}

TEST(OccupancyMessages, AnEmptyMapTakesTheCubesAway) {
  const auto array = toVoxelMarkers(OccupancyVoxels{0.5, {}}, {}, "map");
  ASSERT_EQ(array.markers.size(), 1u);
  EXPECT_EQ(array.markers[0].action, array.markers[0].DELETE);
}

TEST(OccupancyMessages, TheGridKeepsItsLayout) {
  const ProjectedGrid grid{{-3.0, 4.5}, 0.5, 3, 2, {-1, 0, 100, 0, 0, -1}};
  const nav_msgs::OccupancyGrid message = toOccupancyGrid(grid, Stamp::fromSeconds(7.0), "map");
  EXPECT_EQ(message.info.width, 3u);
  EXPECT_EQ(message.info.height, 2u);
  EXPECT_EQ(message.info.resolution, 0.5f);
  EXPECT_EQ(message.info.origin.position.x, -3.0);
  EXPECT_EQ(message.info.origin.position.y, 4.5);
  EXPECT_EQ(message.data, grid.cells);
}

#ifdef REVISIT_SLAM_OCTOMAP_MSGS
TEST(OccupancyMessages, TheOctreeIsReadAsItIsInMemory) {
  const OccupancyVoxels map = mapOfWall({});
  const octomap_msgs::Octomap message = toOctomap(map, Stamp::fromSeconds(12.5), "map");
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(12, 500000000));
  const std::unique_ptr<octomap::AbstractOcTree> tree(octomap_msgs::msgToMap(message));
  const auto* read = dynamic_cast<const octomap::OcTree*>(tree.get());
  ASSERT_NE(read, nullptr);
  EXPECT_GT(read->size(), 20u);
  EXPECT_TRUE(*read == *octreeOf(map));
}
#endif

}  // namespace
}  // namespace revisit_slam
