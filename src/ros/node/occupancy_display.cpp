// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/occupancy_display.h"

#include "revisit_slam/ros/messages/occupancy_messages.h"
#include "revisit_slam/ros/messages/scan_messages.h"

namespace revisit_slam {

OccupancyDisplay::OccupancyDisplay(ros::NodeHandle& node, const std::string& frame,
                                   const OccupancyConfig& config,
                                   std::function<void()> on_subscriber)
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
}

void OccupancyDisplay::draw(const GraphSession& session) {
  const bool cells = cells_.getNumSubscribers() > 0, voxels = voxels_.getNumSubscribers() > 0;
  const bool grid = grid_.getNumSubscribers() > 0;
  if (!config_.enabled || session.graph().size() == 0 || !(cells || voxels || grid)) return;
  place(session);
  const Stamp stamp = session.graph().nodes().back().stamp;
  if (cells) cells_.publish(toPointCloud(occupiedCentres(map_), stamp, frame_));
  if (voxels) voxels_.publish(toVoxelMarkers(map_, stamp, frame_));
  if (grid) grid_.publish(toOccupancyGrid(projectedGrid(map_, config_.grid), stamp, frame_));
}

void OccupancyDisplay::place(const GraphSession& session) {
  for (std::size_t i = 0; i < session.submaps().size(); ++i) {
    const Submap& submap = *session.submaps()[i];
    const SubmapOccupancyPtr& occupancy = session.occupancies()[i];
    if (occupancy && submap.first_scan.value < session.graph().size())
      map_.place(submap.id, occupancy, session.graph().pose(submap.first_scan));
  }
  map_.compose();
}

}  // namespace revisit_slam
