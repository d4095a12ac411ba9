// SPDX-License-Identifier: MIT
#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "revisit_slam/priors/gnss_config.h"
#include "revisit_slam/priors/motion_reading.h"
#include "revisit_slam/priors/priors_config.h"
#include "revisit_slam/util/frame_name.h"

namespace revisit_slam {

/// Of the sensors beside the LiDAR.
using MotionMessage = std::variant<nav_msgs::Odometry::ConstPtr, sensor_msgs::Imu::ConstPtr,
                                   tf2_msgs::TFMessage::ConstPtr, sensor_msgs::NavSatFix::ConstPtr>;

/// Makes readings of messages that measure motion or position. None of them makes it throw.
class MotionReader {
 public:
  /// T_base_sensor of a frame; nothing where TF does not know it.
  using FindExtrinsics = std::function<std::optional<Pose>(const std::string& frame)>;

  /// @throws ParameterError for an antenna that is none.
  MotionReader(const PriorsConfig& config, const GnssConfig& gnss, FindExtrinsics find_extrinsics)
      : odometry_frame_(withoutLeadingSlash(config.odometry_frame)),
        gnss_(gnss),
        antenna_base_(gnss.antennaInBase()),
        find_extrinsics_(std::move(find_extrinsics)) {}

  struct Result {
    std::optional<MotionReading> reading;
    const char* sensor = nullptr;  ///< its name in MotionPriors or GnssTrack
    std::string rejection;         ///< why there is no reading
  };

  /// Nothing where a message of TF is about other frames.
  std::optional<Result> read(const MotionMessage& message);

 private:
  Result readOdometry(const nav_msgs::Odometry& message) const;
  Result readImu(const sensor_msgs::Imu& message) const;
  Result readPosition(const sensor_msgs::NavSatFix& message) const;
  Eigen::Matrix3d covarianceOf(const std::optional<Eigen::Matrix3d>& told) const;
  std::optional<Result> readTransforms(const tf2_msgs::TFMessage& message);

  const std::string odometry_frame_;
  const GnssConfig gnss_;
  const std::optional<Eigen::Vector3d> antenna_base_;  // none: by TF
  const FindExtrinsics find_extrinsics_;
  std::string child_frame_;  // the first that TF moves in odometry_frame_
};

}  // namespace revisit_slam
