// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/path_message.h"

#include <algorithm>

#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {

nav_msgs::Path toPath(const SlamGraph& graph, std::size_t first, const std::string& frame,
                      std::size_t max_poses) {
  constexpr double kSpacing = 1.0;  // m
  nav_msgs::Path path;
  path.header.frame_id = frame;
  const std::vector<Pose> poses = graph.poses();
  double length = 0.0;
  for (std::size_t i = first + 1; i < poses.size(); ++i)
    length += (poses[i].translation - poses[i - 1].translation).norm();
  const double spacing =
      std::max(kSpacing, length / static_cast<double>(std::max<std::size_t>(max_poses, 3) - 2));
  double since_last = spacing;
  for (std::size_t i = first; i < poses.size(); ++i) {
    if (i > first) since_last += (poses[i].translation - poses[i - 1].translation).norm();
    if (since_last < spacing && i + 1 < poses.size()) continue;
    since_last = 0.0;
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = frame;
    pose.header.stamp = toRosTime(graph.nodes()[i].stamp);
    pose.pose = toPoseMessage(poses[i]);
    path.poses.push_back(pose);
  }
  if (!path.poses.empty()) path.header.stamp = path.poses.back().header.stamp;
  return path;
}

}  // namespace revisit_slam
