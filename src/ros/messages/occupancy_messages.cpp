// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/occupancy_messages.h"

#include <algorithm>

#include "revisit_slam/ros/messages/pose_conversions.h"
#ifdef REVISIT_SLAM_OCTOMAP_MSGS
#include <octomap_msgs/conversions.h>

#include "revisit_slam/occupancy/octree.h"
#endif

namespace revisit_slam {
namespace {

constexpr float kLowest = -5.0f, kHighest = 10.0f;  // m, ends of the colours

/// From blue for low over green to red for high.
std_msgs::ColorRGBA colourOf(float height) {
  const float share = std::clamp((height - kLowest) / (kHighest - kLowest), 0.0f, 1.0f);
  std_msgs::ColorRGBA colour;
  colour.r = std::clamp(2.0f * share - 1.0f, 0.0f, 1.0f);
  colour.b = std::clamp(1.0f - 2.0f * share, 0.0f, 1.0f);
  colour.g = 1.0f - colour.r - colour.b;
  colour.a = 1.0f;
  return colour;
}

}  // namespace

nav_msgs::OccupancyGrid toOccupancyGrid(const ProjectedGrid& grid, Stamp stamp,
                                        const std::string& frame) {
  nav_msgs::OccupancyGrid message;
  message.header.stamp = message.info.map_load_time = toRosTime(stamp);
  message.header.frame_id = frame;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position.x = grid.origin.x();
  message.info.origin.position.y = grid.origin.y();
  message.info.origin.orientation.w = 1.0;
  message.data = grid.cells;
  return message;
}

visualization_msgs::MarkerArray toVoxelMarkers(const OccupancyVoxels& map, Stamp stamp,
                                               const std::string& frame) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker& marker = array.markers.emplace_back();
  marker.header.stamp = toRosTime(stamp);
  marker.header.frame_id = frame;
  marker.ns = "occupied";
  marker.type = marker.CUBE_LIST;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = map.resolution;
  for (const Eigen::Vector3f& centre : occupiedCentres(map)) {
    geometry_msgs::Point& point = marker.points.emplace_back();
    point.x = centre.x();
    point.y = centre.y();
    point.z = centre.z();
    marker.colors.push_back(colourOf(centre.z()));
  }
  if (marker.points.empty()) marker.action = marker.DELETE;
  return array;
}

#ifdef REVISIT_SLAM_OCTOMAP_MSGS
octomap_msgs::Octomap toOctomap(const OccupancyVoxels& map, Stamp stamp, const std::string& frame) {
  octomap_msgs::Octomap message;
  message.header.stamp = toRosTime(stamp);
  message.header.frame_id = frame;
  octomap_msgs::binaryMapToMsg(*octreeOf(map), message);
  return message;
}
#endif

}  // namespace revisit_slam
