// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/ros/input/arrived_scan.h"
#include "revisit_slam/ros/input/scan_topics.h"

namespace revisit_slam {

/// Takes scans from the topics `points` and `livox_points`, or from those of several sensors
/// (input/topics), in threads of the node, and reads them.
class ScanSubscription {
 public:
  using OnScan = std::function<void(const ArrivedScan&)>;
  /// Hears why a message is none.
  using OnDamaged = std::function<void(const std::string& fault)>;

  /// @throws ParameterError on a word that is no choice.
  explicit ScanSubscription(const ScanInputConfig& config);
  ~ScanSubscription() { unsubscribe(); }

  /// Without a limit to how many messages may wait.
  void subscribe(ros::NodeHandle& node, const OnScan& on_scan, const OnDamaged& on_damaged);
  void unsubscribe();

  /// For one thread.
  ScanReading read(const ArrivedScan& scan) { return scan.readBy(readers_[scan.sensor]); }
  /// Where point times come from, and what to do where there are none, as ScanReader says it.
  const std::string& description() const { return toBeTold(readers_).description(); }
  std::string remedy() const { return toBeTold(readers_).remedy(); }

  /// Messages so far, the damaged ones included.
  std::size_t arrived() const { return arrived_; }
  /// Those that were named by whoever started the node.
  std::vector<std::string> topics() const;
  /// Whether they are those of several sensors, and may be of either type.
  bool areOfSeveral() const { return !given_topics_.empty(); }

 private:
  void subscribeToBytes(ros::NodeHandle& node, const std::string& topic, std::size_t sensor,
                        const OnScan& on_scan);

  const std::vector<std::string> given_topics_;  // of several sensors
  std::vector<ScanReader> readers_;              // one for each sensor
  std::atomic<std::size_t> arrived_{0};
  std::vector<ros::Subscriber> subscribers_;
  bool livox_is_named_ = false;
};

/// What the master knows to be published.
std::vector<TypedTopic> publishedTopics();

}  // namespace revisit_slam
