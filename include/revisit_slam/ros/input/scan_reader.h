// SPDX-License-Identifier: MIT
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/input/point_cloud.h"
#include "revisit_slam/input/point_reader.h"
#include "revisit_slam/input/scan_input_config.h"
#include "revisit_slam/input/scan_reading.h"
#include "revisit_slam/ros/input/livox_custom_msg.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// The frame_id of a message with scans; empty where it has no header.
std::string frameOf(const topic_tools::ShapeShifter& message);

/// Makes scans of the messages on one topic, or of the clouds of one dataset, in the order in which
/// they come. None of them makes it throw. Not for use by several threads at a time.
class ScanReader {
 public:
  /// Throws ParameterError on a word that is no choice.
  explicit ScanReader(const ScanInputConfig& config, const Pose& T_base_sensor = {});

  ScanReading read(const PointCloud& cloud);
  /// `arrival`: when the message was received.
  ScanReading read(const sensor_msgs::PointCloud2& cloud, Stamp arrival = {});
  /// PointCloud2 or the CustomMsg of either Livox driver.
  ScanReading read(const RawMessage& message);
  ScanReading read(const topic_tools::ShapeShifter& message, Stamp arrival = {});

  /// One line on where the point times come from, or why there is no deskewing. It changes when
  /// that does, so that it can be logged once. Empty before the first scan.
  const std::string& description() const { return reader_.description(); }
  /// What a user can do about scans without point times; empty where nothing has to be done.
  std::string remedy() const { return reader_.remedy(); }
  /// Whether the last scan had point times.
  bool deskewing() const { return reader_.deskewing(); }

  void setExtrinsics(const Pose& T_base_sensor) { T_base_sensor_ = T_base_sensor; }

 private:
  void stampByArrival(PointMessage& message, Stamp arrival) const;
  ScanReading readCloud(const PointMessage& cloud);
  ScanReading readStampedCloud(PointMessage cloud, Stamp arrival);
  ScanReading readLivox(LivoxCustomMsg message, Stamp arrival);
  ScanReading readPoints(const PointMessage& message, const ReferenceStamp& reference);

  ScanInputConfig config_;
  PointReader reader_;
  Pose T_base_sensor_;
  RawMessage raw_;
};

/// Of the readers of several sensors the first whose scans a user has to do something about, else
/// the first.
const ScanReader& toBeTold(const std::vector<ScanReader>& readers);

}  // namespace revisit_slam
