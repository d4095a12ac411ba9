// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/motion_subscription.h"

#include <utility>

namespace revisit_slam {
namespace {

/// Half a minute of a fast inertial unit: more the odometry could not use, were it to stand still.
constexpr std::size_t kMost = 30'000;

}  // namespace

void MotionSubscription::subscribe(ros::NodeHandle& node, std::function<void()> on_message) {
  on_message_ = std::move(on_message);
  if (!priors_.odometry_topic.empty())
    subscribeTo<nav_msgs::Odometry>(priors_.odometry_topic, node);
  if (!priors_.odometry_frame.empty()) subscribeTo<tf2_msgs::TFMessage>("/tf", node);
  if (!priors_.imu_topic.empty()) subscribeTo<sensor_msgs::Imu>(priors_.imu_topic, node);
  if (gnss_.isConnected()) subscribeTo<sensor_msgs::NavSatFix>(gnss_.topic, node);
}

void MotionSubscription::unsubscribe() {
  for (ros::Subscriber& subscriber : subscribers_) subscriber.shutdown();
}

template <typename Message>
void MotionSubscription::subscribeTo(const std::string& topic, ros::NodeHandle& node) {
  const uint32_t depth = 0;  // no limit: a gap costs a scan its prediction
  subscribers_.push_back(node.subscribe<Message>(
      topic, depth, [this](const boost::shared_ptr<const Message>& message) { put(message); }));
}

void MotionSubscription::put(MotionMessage message) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back(std::move(message));
    if (messages_.size() > kMost) messages_.pop_front();
  }
  on_message_();
}

std::vector<MotionReader::Result> MotionSubscription::readAll() {
  std::vector<MotionReader::Result> results;
  for (const MotionMessage& message : takeAll())
    if (std::optional<MotionReader::Result> result = reader_.read(message))
      results.push_back(std::move(*result));
  return results;
}

std::deque<MotionMessage> MotionSubscription::takeAll() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(messages_, {});
}

}  // namespace revisit_slam
