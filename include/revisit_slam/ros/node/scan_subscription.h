// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/ros/input/arrived_scan.h"
#include "revisit_slam/ros/input/scan_topics.h"

namespace revisit_slam {

/// Takes scans from the topics `points` and `livox_points`, in threads of the node.
class ScanSubscription {
 public:
  using OnScan = std::function<void(const ArrivedScan&)>;
  /// Hears why a message is none.
  using OnDamaged = std::function<void(const std::string& fault)>;

  void subscribe(ros::NodeHandle& node, const OnScan& on_scan, const OnDamaged& on_damaged);
  void unsubscribe();

  /// Messages so far, the damaged ones included.
  std::size_t arrived() const { return arrived_; }
  /// Those that were named by whoever started the node.
  std::vector<std::string> topics() const;

 private:
  std::atomic<std::size_t> arrived_{0};
  ros::Subscriber points_, livox_;
  bool livox_is_named_ = false;
};

/// What the master knows to be published.
std::vector<TypedTopic> publishedTopics();

}  // namespace revisit_slam
