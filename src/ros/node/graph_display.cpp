// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/graph_display.h"

#include "revisit_slam/ros/messages/coloured_cloud.h"
#include "revisit_slam/ros/messages/display.h"
#include "revisit_slam/ros/messages/loop_markers.h"
#include "revisit_slam/ros/messages/path_message.h"

namespace revisit_slam {
namespace {

constexpr std::size_t kMaxPoses = 2'000;

std::vector<SubmapPtr> placedSubmaps(const GraphSession& session) {
  std::vector<SubmapPtr> placed;
  if (!session.isPlaced()) return placed;
  for (const SubmapPtr& submap : session.submaps())
    if (session.has(submap->first_scan)) placed.push_back(submap);
  return placed;
}

}  // namespace

GraphDisplay::GraphDisplay(ros::NodeHandle& node, const SlamConfig& config,
                           std::function<void()> on_subscriber)
    : frame_(config.frames.map),
      min_inlier_weight_(config.backend.min_inlier_weight),
      max_points_(config.live.max_cloud_points),
      extension_(node, config, on_subscriber) {
  const bool latch = true;
  const ros::SubscriberStatusCallback connected =
      [on_subscriber](const ros::SingleSubscriberPublisher&) { on_subscriber(); };
  const ros::SubscriberStatusCallback none;
  const ros::VoidConstPtr untracked;
  using Cloud = sensor_msgs::PointCloud2;
  using Markers = visualization_msgs::MarkerArray;
  path_ = node.advertise<nav_msgs::Path>("path", 1, connected, none, untracked, latch);
  edges_ = node.advertise<Markers>("loop_edges", 1, connected, none, untracked, latch);
  cloud_ = node.advertise<Cloud>("map_cloud", 1, connected, none, untracked, latch);
}

void GraphDisplay::draw(const GraphSession& session) {
  const SlamGraph& graph = session.graph();
  extension_.draw(session);
  drawPath(session);
  if (edges_.getNumSubscribers() > 0)
    edges_.publish(toLoopEdges(graph, min_inlier_weight_, frame_));
  if (cloud_.getNumSubscribers() > 0) {
    const std::vector<SubmapPtr> placed = placedSubmaps(session);
    std::size_t total = 0;
    for (const SubmapPtr& submap : placed) total += session.pointsOf(*submap);
    ColouredCloud cloud(frame_, total, max_points_);
    for (const SubmapPtr& submap : placed)
      cloud.add({&session.whole(*submap)->points, graph.pose(submap->first_scan), colour(1, 1, 1)});
    cloud_.publish(cloud.take());
  }
}

void GraphDisplay::drawPath(const GraphSession& session) const {
  if (path_.getNumSubscribers() == 0) return;
  const SlamGraph& graph = session.graph();
  const std::size_t first = session.isPlaced() ? session.scansBefore() : graph.size();
  path_.publish(toPath(graph, first, frame_, kMaxPoses));
}

}  // namespace revisit_slam
