// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/odometry_topics.h"

#include <boost/make_shared.hpp>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/ros/messages/scan_messages.h"
#include "revisit_slam/util/frame_name.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

OdometryTopics::OdometryTopics(ros::NodeHandle& node, const SlamConfig& config)
    : odom_frame_(ownOdomFrame(config)), broadcasts_(config.live.broadcast_odom) {
  if (broadcasts_ && withoutLeadingSlash(config.priors.odometry_frame) == config.frames.odom)
    throw ParameterError("priors/odometry_frame '" + config.frames.odom +
                         "' is the frame that this node broadcasts: set live/broadcast_odom to "
                         "false");
  const std::string& topic = config.priors.odometry_topic;
  for (const char* own : {"odometry", "odometry_raw"})
    if (!topic.empty() && node.resolveName(topic) == node.resolveName(own))
      throw ParameterError("priors/odometry_topic '" + topic +
                           "' is a topic of revisit_slam itself: remap one of the two, or run "
                           "revisit_slam in a namespace");
  const ros::Publisher registered = node.advertise<OdometryOutput>("registered_scan", 100);
  registered_ = {registered, [registered] { return registered.getNumSubscribers() > 0; }};
  odometry_ = node.advertise<nav_msgs::Odometry>("odometry_raw", 100);
  cloud_ = node.advertise<sensor_msgs::PointCloud2>("deskewed_points", 2);
}

std::string OdometryTopics::broadcastFault(const SensorPlacement& placement) {
  if (!broadcasts_) return "";
  const std::string& base = placement.baseFrame();
  const std::string parent = placement.parentOfBase(has_broadcast_ ? odom_frame_ : "");
  has_broadcast_ = true;
  if (parent.empty()) return "";
  return "TF places '" + base + "' in '" + parent + "' already, and now in '" + odom_frame_ +
         "' as well: transforms will jump. If '" + parent +
         "' is where the odometry of the robot moves it, start with broadcast_odom:=false; if '" +
         base + "' is a part of the robot, with base_frame:= the frame at the root of the robot";
}

void OdometryTopics::publish(const OdometryOutput& output, const std::string& base_frame) {
  const RegisteredScan& scan = *output.scan;
  if (broadcasts_) tf_broadcaster_.sendTransform(toTransform(scan, odom_frame_, base_frame));
  odometry_.publish(toOdometry(scan, odom_frame_, base_frame));
  registered_.publish(boost::make_shared<const OdometryOutput>(output));
  if (cloud_.getNumSubscribers() > 0)
    cloud_.publish(boost::make_shared<sensor_msgs::PointCloud2>(
        toPointCloud(scan.points_base, scan.stamp, base_frame)));
}

}  // namespace revisit_slam
