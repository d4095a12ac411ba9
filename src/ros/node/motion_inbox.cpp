// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/motion_inbox.h"

#include <utility>

namespace revisit_slam {
namespace {

/// Half a minute of a fast inertial unit: more the odometry could not use, were it to stand still.
constexpr std::size_t kMost = 30'000;

}  // namespace

void MotionInbox::subscribe(ros::NodeHandle& node, const PriorsConfig& config,
                            const GnssConfig& gnss, std::function<void()> on_message) {
  on_message_ = std::move(on_message);
  if (!config.odometry_topic.empty()) subscribeTo<nav_msgs::Odometry>(config.odometry_topic, node);
  if (!config.odometry_frame.empty()) subscribeTo<tf2_msgs::TFMessage>("/tf", node);
  if (!config.imu_topic.empty()) subscribeTo<sensor_msgs::Imu>(config.imu_topic, node);
  if (gnss.isConnected()) subscribeTo<sensor_msgs::NavSatFix>(gnss.topic, node);
}

void MotionInbox::unsubscribe() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
}

template <typename Message>
void MotionInbox::subscribeTo(const std::string& topic, ros::NodeHandle& node) {
  const uint32_t depth = 0;  // no limit: a gap costs a scan its prediction
  subscribers_.push_back(node.subscribe<Message>(
      topic, depth, [this](const boost::shared_ptr<const Message>& message) { put(message); }));
}

void MotionInbox::put(MotionMessage message) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back(std::move(message));
    if (messages_.size() > kMost) messages_.pop_front();
  }
  on_message_();
}

std::deque<MotionMessage> MotionInbox::takeAll() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(messages_, {});
}

}  // namespace revisit_slam
