// SPDX-License-Identifier: MIT
#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>

#include <string>

#include "revisit_slam/ros/node/patient_publisher.h"
#include "revisit_slam/ros/node/sensor_placement.h"
#include "revisit_slam/ros/node/stage_topics.h"
#include "revisit_slam/slam/slam_config.h"

namespace revisit_slam {

/// What the odometry tells of each scan: registered_scan for the other nodelets, odometry_raw,
/// deskewed_points and, unless the robot broadcasts it, the transform. For one thread.
class OdometryTopics {
 public:
  /// @throws ParameterError where motion would be measured by what is broadcast here.
  OdometryTopics(ros::NodeHandle& node, const SlamConfig& config);

  /// Why TF would have two parents of the base, with what to do; empty where it will not. Before
  /// anything of the session is published.
  std::string broadcastFault(const SensorPlacement& placement);

  void publish(const OdometryOutput& output, const std::string& base_frame);

 private:
  const std::string odom_frame_;
  const bool broadcasts_;
  bool has_broadcast_ = false;
  tf2_ros::TransformBroadcaster tf_broadcaster_;
  PatientPublisher<OdometryOutput> registered_;
  ros::Publisher odometry_, cloud_;
};

}  // namespace revisit_slam
