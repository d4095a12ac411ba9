// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/scan_subscription.h"

#include <ros/master.h>

#include <algorithm>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/node/cloud_subscription.h"
#include "revisit_slam/util/number_list.h"

namespace revisit_slam {

ScanSubscription::ScanSubscription(const ScanInputConfig& config)
    : given_topics_(wordsOf(config.topics)),
      readers_(std::max<std::size_t>(1, given_topics_.size()), ScanReader(config)) {}

void ScanSubscription::subscribe(ros::NodeHandle& node, const OnScan& on_scan,
                                 const OnDamaged& on_damaged) {
  for (std::size_t sensor = 0; sensor < given_topics_.size(); ++sensor)
    subscribeToBytes(node, given_topics_[sensor], sensor, on_scan);
  if (!given_topics_.empty()) return;
  subscribers_.push_back(subscribeToClouds(
      node, "points",
      [this, on_scan](const ArrivedScan::Cloud& cloud) {
        ++arrived_;
        on_scan({cloud, toStamp(ros::Time::now())});
      },
      [this, on_damaged](const std::string& fault) {
        ++arrived_;
        on_damaged(fault);
      }));
  subscribeToBytes(node, "livox_points", 0, on_scan);
  livox_is_named_ = node.resolveName("livox_points") != node.resolveName("livox_points", false);
}

void ScanSubscription::subscribeToBytes(ros::NodeHandle& node, const std::string& topic,
                                        std::size_t sensor, const OnScan& on_scan) {
  const uint32_t depth = 0;  // no limit: whoever listens drops scans, and counts them
  subscribers_.push_back(node.subscribe<topic_tools::ShapeShifter>(
      topic, depth, [this, sensor, on_scan](const ArrivedScan::Bytes& message) {
        ++arrived_;
        on_scan({message, toStamp(ros::Time::now()), sensor});
      }));
}

void ScanSubscription::unsubscribe() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
}

std::vector<std::string> ScanSubscription::topics() const {
  std::vector<std::string> names;
  for (const ros::Subscriber& subscriber : subscribers_) names.push_back(subscriber.getTopic());
  if (given_topics_.empty() && !livox_is_named_) names.pop_back();
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
