// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/ros/input/motion_reader.h"

namespace revisit_slam {

/// Messages that measure motion and position, in the order of their arrival, until the thread of
/// the odometry takes them. They are many and small, and never displace a scan.
class MotionInbox {
 public:
  ~MotionInbox() { unsubscribe(); }

  /// To what the configuration names. `on_message` is called in threads of the node.
  void subscribe(ros::NodeHandle& node, const PriorsConfig& config, const GnssConfig& gnss,
                 std::function<void()> on_message);
  void unsubscribe();

  /// All that came since.
  std::deque<MotionMessage> takeAll();

 private:
  template <typename Message>
  void subscribeTo(const std::string& topic, ros::NodeHandle& node);
  void put(MotionMessage message);

  std::function<void()> on_message_;
  std::mutex mutex_;  // guards the next one
  std::deque<MotionMessage> messages_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace revisit_slam
