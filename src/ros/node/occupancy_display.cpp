// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/occupancy_display.h"

#include <ros/console.h>

#include <stdexcept>

#include "revisit_slam/ros/messages/occupancy_messages.h"
#include "revisit_slam/ros/messages/scan_messages.h"

namespace revisit_slam {
namespace {

/// A message of 200 MB, 7 km by 7 km of voxels of half a metre: it goes out with each correction.
constexpr double kMostCells = 2e8;

/// What a map that is too large does not fit into is no reason to leave out the rest.
template <typename Publish>
void publishWhereItFits(const Publish& publish) {
  try {
    publish();
  } catch (const std::exception& error) {
    ROS_WARN_THROTTLE(60.0, "not published: %s", error.what());
  }
}

}  // namespace

OccupancyDisplay::OccupancyDisplay(ros::NodeHandle& node, const std::string& frame,
                                   const OccupancyConfig& config,
                                   const std::function<void()>& on_subscriber)
    : frame_(frame), config_(config), map_(config) {
  const bool latch = true;
  const ros::SubscriberStatusCallback connected =
      [on_subscriber](const ros::SingleSubscriberPublisher&) { on_subscriber(); };
  const ros::SubscriberStatusCallback none;
  const ros::VoidConstPtr untracked;
  using Cloud = sensor_msgs::PointCloud2;
  using Markers = visualization_msgs::MarkerArray;
  using Grid = nav_msgs::OccupancyGrid;
  cells_ = node.advertise<Cloud>("occupied_cells", 1, connected, none, untracked, latch);
  voxels_ = node.advertise<Markers>("occupied_voxels", 1, connected, none, untracked, latch);
  grid_ = node.advertise<Grid>("projected_map", 1, connected, none, untracked, latch);
#ifdef REVISIT_SLAM_OCTOMAP_MSGS
  using Octomap = octomap_msgs::Octomap;
  octomap_ = node.advertise<Octomap>("octomap", 1, connected, none, untracked, latch);
#endif
}

void OccupancyDisplay::draw(const GraphSession& session) {
  const bool cells = cells_.getNumSubscribers() > 0, voxels = voxels_.getNumSubscribers() > 0;
  const bool grid = grid_.getNumSubscribers() > 0, octomap = octomap_.getNumSubscribers() > 0;
  const bool wanted = config_.enabled && (cells || voxels || grid || octomap);
  if (!wanted || session.graph().size() == 0 || !session.isPlaced()) return;
  place(session);
  const OccupancyVoxels& map = map_.voxels();
  const Stamp stamp = session.graph().nodes().back().stamp;
  if (cells) cells_.publish(toPointCloud(occupiedCentres(map), stamp, frame_));
  if (voxels) voxels_.publish(toVoxelMarkers(map, stamp, frame_));
  if (grid)
    publishWhereItFits([&] {
      grid_.publish(toOccupancyGrid(projectedGrid(map, config_.grid, kMostCells), stamp, frame_));
    });
#ifdef REVISIT_SLAM_OCTOMAP_MSGS
  if (octomap) publishWhereItFits([&] { octomap_.publish(toOctomap(map, stamp, frame_)); });
#endif
}

void OccupancyDisplay::place(const GraphSession& session) {
  for (const SubmapPtr& submap : session.submaps()) {
    if (!session.has(submap->first_scan)) continue;
    const Pose T_map_submap = session.graph().pose(submap->first_scan);
    if (map_.move(submap->id, T_map_submap)) continue;  // what has been read once is not again
    if (const SubmapOccupancyPtr occupancy = session.occupancy(*submap))
      map_.place(submap->id, occupancy, T_map_submap);
  }
  map_.compose();
}

}  // namespace revisit_slam
