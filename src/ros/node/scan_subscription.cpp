// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/scan_subscription.h"

#include <ros/master.h>
#include <ros/message_event.h>
#include <ros/this_node.h>

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
      [this, on_scan](const ros::MessageEvent<const sensor_msgs::PointCloud2>& cloud) {
        ++arrived_;
        on_scan({cloud.getConstMessage(), toStamp(cloud.getReceiptTime())});
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
  using Event = ros::MessageEvent<const topic_tools::ShapeShifter>;
  const boost::function<void(const Event&)> take = [this, sensor, on_scan](const Event& message) {
    ++arrived_;
    on_scan({message.getConstMessage(), toStamp(message.getReceiptTime()), sensor});
  };
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event&>(topic, depth, take);
  subscribers_.push_back(node.subscribe(options));
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
  XmlRpc::XmlRpcValue request, response, known;
  request[0] = ros::this_node::getName();
  request[1] = "";
  const bool waits_for_master = false;
  std::vector<TypedTopic> topics;
  if (!ros::master::execute("getPublishedTopics", request, response, known, waits_for_master))
    return topics;
  for (int i = 0; i < known.size(); ++i) topics.push_back({known[i][0], known[i][1]});
  return topics;
}

}  // namespace revisit_slam
