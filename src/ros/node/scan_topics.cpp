// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/scan_topics.h"

#include <algorithm>

#include "revisit_slam/ros/node/cloud_subscription.h"
#include "revisit_slam/util/number_list.h"

namespace revisit_slam {

using topic_tools::ShapeShifter;

ScanTopics::ScanTopics(const ScanInputConfig& config)
    : topics_(wordsOf(config.topics)),
      readers_(std::max<std::size_t>(1, topics_.size()), ScanReader(config)) {}

void ScanTopics::subscribe(ros::NodeHandle& node,
                           const std::function<void(const ReceivedScan&)>& on_scan,
                           const std::function<void(const std::string&)>& on_damaged) {
  const uint32_t depth =
      0;  // no limit: only the queue of the odometry drops scans, and counts them
  const auto subscribe_to_bytes = [&](const std::string& topic, std::size_t sensor) {
    subscribers_.push_back(node.subscribe<ShapeShifter>(
        topic, depth, [on_scan, sensor](const ShapeShifter::ConstPtr& message) {
          on_scan({nullptr, message, sensor});
        }));
  };
  for (std::size_t sensor = 0; sensor < topics_.size(); ++sensor)
    subscribe_to_bytes(topics_[sensor], sensor);
  if (!topics_.empty()) return;
  subscribers_.push_back(subscribeToClouds(
      node, "points",
      [on_scan](const sensor_msgs::PointCloud2::ConstPtr& cloud) {
        on_scan({cloud, nullptr, 0});
      },
      on_damaged));
  subscribe_to_bytes("livox_points", 0);
}

void ScanTopics::unsubscribe() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
}

ScanReading ScanTopics::read(const ReceivedScan& scan) {
  ScanReader& reader = readers_[scan.sensor];
  ScanReading reading = scan.cloud ? reader.read(*scan.cloud) : reader.read(*scan.bytes);
  reading.sensor = scan.sensor;
  return reading;
}

}  // namespace revisit_slam
