// SPDX-License-Identifier: MIT
#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/ros/input/scan_reader.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// A bag or topic that cannot be used; the message says what to do.
class BagError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of a recorded message. @throws std::exception where the bag is damaged there.
RawMessage rawMessageOf(const rosbag::MessageInstance& instance);

/// @throws std::exception unless there are the bytes for the transforms that are announced, for
/// which memory is taken before they are read.
tf2_msgs::TFMessage transformsOf(const RawMessage& raw);

/// Reads a recorded scan; one where the bag is damaged is a rejection too.
ScanReading readScan(const rosbag::MessageInstance& instance, ScanReader& reader);

/// The scans of one or more topics in one or more bags, in the order in which they were recorded.
class BagScans {
 public:
  /// An empty topic stands for the only topic with scans. @throws BagError
  BagScans(const std::vector<std::string>& paths, const std::string& topic)
      : BagScans(paths, std::vector<std::string>{topic}) {}
  BagScans(const std::vector<std::string>& paths, const std::vector<std::string>& topics);

  /// Between spaces.
  std::string topic() const;
  /// The number of a topic with scans.
  std::size_t sensorOf(const std::string& topic) const;
  std::size_t sensors() const { return topics_.size(); }
  std::size_t size() { return scans_->size(); }
  rosbag::View& messages() { return *scans_; }
  /// The scans and, in the order in which all were recorded, what measures motion and
  /// position.
  /// @throws BagError where a topic is missing or of another type.
  std::unique_ptr<rosbag::View> messagesWith(const PriorsConfig& priors,
                                             const GnssConfig& gnss) const;

  bool hasTransforms() const { return has_transforms_; }
  /// Messages with transforms that are damaged: those in them are left out.
  std::size_t damagedTransforms() const { return damaged_transforms_; }
  /// The frame_id of the first scan of a topic that has a header.
  std::string sensorFrame(std::size_t sensor = 0);
  /// Pose of a sensor on the robot as the bags' /tf_static and /tf have it; nothing when they do
  /// not connect the two frames.
  std::optional<Pose> findExtrinsics(const std::string& base_frame,
                                     const std::string& sensor_frame) const;
  /// Frames that the bags' transforms connect this one with.
  std::vector<std::string> framesAround(const std::string& frame) const;

 private:
  void open(const std::string& path);
  std::string chooseTopic(const std::string& wanted);
  void requireTopic(const std::string& topic, const std::string& type,
                    const std::string& parameter) const;
  void readTransforms();

  std::vector<std::unique_ptr<rosbag::Bag>> bags_;
  std::vector<std::string> topics_;
  std::unique_ptr<rosbag::View> scans_;
  bool has_transforms_ = false;
  std::size_t damaged_transforms_ = 0;
  tf2::BufferCore transforms_;
};

}  // namespace revisit_slam
