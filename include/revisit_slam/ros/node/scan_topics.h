// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>
#include <topic_tools/shape_shifter.h>

#include <functional>
#include <string>
#include <vector>

#include "revisit_slam/ros/input/scan_reader.h"

namespace revisit_slam {

/// A message with a scan as it came: a cloud, or bytes of a type that is found out.
struct ReceivedScan {
  sensor_msgs::PointCloud2::ConstPtr cloud;
  topic_tools::ShapeShifter::ConstPtr bytes;  ///< where there is no cloud
  std::size_t sensor = 0;                     ///< number of its topic among input/topics

  std::string frame() const { return cloud ? cloud->header.frame_id : frameOf(*bytes); }
};

/// The topics of the scans: `points` and `livox_points`, or those of several sensors
/// (input/topics), and what reads their messages.
class ScanTopics {
 public:
  /// @throws ParameterError on a word that is no choice.
  explicit ScanTopics(const ScanInputConfig& config);
  ~ScanTopics() { unsubscribe(); }

  /// Without a limit to how many messages may wait. Both are called in threads of the node;
  /// `on_damaged` with what is wrong.
  void subscribe(ros::NodeHandle& node, const std::function<void(const ReceivedScan&)>& on_scan,
                 const std::function<void(const std::string&)>& on_damaged);
  void unsubscribe();

  /// For one thread.
  ScanReading read(const ReceivedScan& scan);
  /// Where the point times come from, as ScanReader says it.
  const std::string& description() const { return readers_.front().description(); }

 private:
  std::vector<std::string> topics_;  // of several sensors
  std::vector<ScanReader> readers_;  // one for each sensor
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace revisit_slam
