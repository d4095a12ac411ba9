// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "revisit_slam/priors/motion_reading.h"
#include "revisit_slam/priors/priors_config.h"

namespace revisit_slam {

using MotionMessage = std::variant<nav_msgs::Odometry::ConstPtr, sensor_msgs::Imu::ConstPtr,
                                   tf2_msgs::TFMessage::ConstPtr>;

/// Makes readings of messages that measure motion. None of them makes it throw.
class MotionReader {
 public:
  /// T_base_sensor of a frame; nothing where TF does not know it.
  using FindExtrinsics = std::function<std::optional<Pose>(const std::string& frame)>;

  MotionReader(const PriorsConfig& config, FindExtrinsics find_extrinsics)
      : odometry_frame_(config.odometry_frame), find_extrinsics_(std::move(find_extrinsics)) {}

  struct Result {
    std::optional<MotionReading> reading;
    const char* sensor = nullptr;  ///< MotionPriors' name of it
    std::string rejection;         ///< why there is no reading
  };

  /// Nothing where a message of TF is about other frames.
  std::optional<Result> read(const MotionMessage& message);

 private:
  Result readOdometry(const nav_msgs::Odometry& message) const;
  Result readImu(const sensor_msgs::Imu& message) const;
  std::optional<Result> readTransforms(const tf2_msgs::TFMessage& message);

  const std::string odometry_frame_;
  const FindExtrinsics find_extrinsics_;
  std::string child_frame_;  // the first that TF moves in odometry_frame_
};

}  // namespace revisit_slam
