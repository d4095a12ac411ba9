// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/extension_display.h"

#include <ros/console.h>

#include "revisit_slam/ros/messages/localization_messages.h"

namespace revisit_slam {
namespace {

/// Where the newest scan is in the map, as the graph has it.
Localization stateOf(const GraphSession& session) {
  Localization now;
  const SlamGraph& graph = session.graph();
  if (session.prior() == nullptr) {
    now.reason = "the session goes on from no map";
    return now;
  }
  if (!session.isPlaced() || graph.nodes().empty()) {
    now.reason = "no loop ties the drive to the map yet";
    return now;
  }
  const GraphNode& newest = graph.nodes().back();
  now.scan = newest.id;
  now.stamp = newest.stamp;
  now.state = LocalizationState::localized;
  now.T_map_odom = graph.T_map_odom();
  now.T_map_base = graph.pose(newest.id);
  for (const LoopEdge& edge : graph.loops())
    if (edge.state == LoopState::active && edge.loop.target.session != session.id())
      now.target = edge.loop.target;
  return now;
}

std::vector<SubmapPtr> submapsOf(const KnownMap& map) {
  std::vector<SubmapPtr> submaps;
  for (const LocalMapPtr& local_map : map.maps)
    submaps.insert(submaps.end(), local_map->submaps.begin(), local_map->submaps.end());
  return submaps;
}

}  // namespace

ExtensionDisplay::ExtensionDisplay(ros::NodeHandle& node, const SlamConfig& config,
                                   const std::function<void()>& on_subscriber)
    : frame_(config.frames.map), max_points_(config.live.max_cloud_points) {
  const bool latch = true;
  const ros::SubscriberStatusCallback connected =
      [on_subscriber](const ros::SingleSubscriberPublisher&) { on_subscriber(); };
  const ros::SubscriberStatusCallback none;
  map_ = node.advertise<sensor_msgs::PointCloud2>("prior_map", 1, connected, none,
                                                  ros::VoidConstPtr(), latch);
  status_ = node.advertise<LocalizationStatus>("localization", 10, latch);
  text_ = node.advertise<visualization_msgs::Marker>("localization_text", 1, latch);
}

void ExtensionDisplay::draw(const GraphSession& session) {
  const bool goes_on = session.prior() != nullptr;
  if (map_.getNumSubscribers() > 0) drawMap(session);
  if (!goes_on && !told_) return;
  const Localization now = stateOf(session);
  const SlamGraph& graph = session.graph();
  const Eigen::Vector3d begin = graph.nodes().empty()
                                    ? Eigen::Vector3d::Zero()
                                    : graph.pose(graph.nodes().front().id).translation;
  text_.publish(toStateText(now, begin, frame_));
  if (told_of_ == session.id() && told_ == now.state) return;
  told_of_ = session.id();
  told_ = now.state;
  status_.publish(toStatus(now, frame_));
  if (now.state == LocalizationState::localized)
    ROS_INFO("the drive was found in the map that it goes on from");
}

/// A map that is no longer gone on from is taken away.
void ExtensionDisplay::drawMap(const GraphSession& session) {
  if (drawn_ != session.prior()) {
    drawn_ = session.prior();
    cloud_ = PriorCloud();
    if (drawn_) cloud_ = PriorCloud(submapsOf(*drawn_), *drawn_->library, max_points_);
  }
  const SessionGroups groups(session.graph().loops());
  map_.publish(cloud_.draw(frame_, [&](const Submap& submap) -> std::optional<Pose> {
    if (!groups.areTied(submap.id.session, session.graph().nodes().front().id.session))
      return std::nullopt;
    return session.graph().pose(submap.first_scan);
  }));
}

}  // namespace revisit_slam
