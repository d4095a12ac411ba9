// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/ros/input/motion_reader.h"

namespace revisit_slam {

/// Messages that measure motion and position, and what reads them. They are many and small, and
/// never displace a scan: they are kept in the order of their arrival until the thread of the
/// odometry reads them.
class MotionSubscription {
 public:
  MotionSubscription(const PriorsConfig& priors, const GnssConfig& gnss,
                     MotionReader::FindExtrinsics find_extrinsics)
      : priors_(priors), gnss_(gnss), reader_(priors, gnss, std::move(find_extrinsics)) {}
  ~MotionSubscription() { unsubscribe(); }

  /// To what the configuration names. `on_message` is called in threads of the node.
  void subscribe(ros::NodeHandle& node, std::function<void()> on_message);
  void unsubscribe();

  /// All that came since.
  std::vector<MotionReader::Result> readAll();

 private:
  template <typename Message>
  void subscribeTo(const std::string& topic, ros::NodeHandle& node);
  void put(MotionMessage message);
  std::deque<MotionMessage> takeAll();

  const PriorsConfig priors_;
  const GnssConfig gnss_;
  MotionReader reader_;
  std::function<void()> on_message_;
  std::mutex mutex_;  // guards the next one
  std::deque<MotionMessage> messages_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace revisit_slam
