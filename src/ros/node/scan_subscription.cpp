// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/scan_subscription.h"

#include <ros/master.h>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/node/cloud_subscription.h"

namespace revisit_slam {

void ScanSubscription::subscribe(ros::NodeHandle& node, const OnScan& on_scan,
                                 const OnDamaged& on_damaged) {
  const auto take = [this, on_scan](const auto& message) {
    ++arrived_;
    on_scan({message, toStamp(ros::Time::now())});
  };
  points_ = subscribeToClouds(
      node, "points", [take](const ArrivedScan::Cloud& cloud) { take(cloud); },
      [this, on_damaged](const std::string& fault) {
        ++arrived_;
        on_damaged(fault);
      });
  const uint32_t depth = 0;  // no limit: whoever listens drops scans, and counts them
  livox_ = node.subscribe<topic_tools::ShapeShifter>(
      "livox_points", depth, [take](const ArrivedScan::Livox& message) { take(message); });
  livox_is_named_ = node.resolveName("livox_points") != node.resolveName("livox_points", false);
}

void ScanSubscription::unsubscribe() {
  points_.shutdown();
  livox_.shutdown();
}

std::vector<std::string> ScanSubscription::topics() const {
  std::vector<std::string> names{points_.getTopic()};
  if (livox_is_named_) names.push_back(livox_.getTopic());
  return names;
}

std::vector<TypedTopic> publishedTopics() {
  ros::master::V_TopicInfo known;
  ros::master::getTopics(known);
  std::vector<TypedTopic> topics;
  for (const ros::master::TopicInfo& topic : known) topics.push_back({topic.name, topic.datatype});
  return topics;
}

}  // namespace revisit_slam
