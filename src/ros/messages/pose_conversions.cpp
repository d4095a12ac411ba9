// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

geometry_msgs::Quaternion toQuaternionMessage(const Eigen::Quaterniond& q) {
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

/// geometry_msgs has two types for three coordinates.
template <typename Message>
Message toCoordinates(const Eigen::Vector3d& p) {
  Message message;
  message.x = p.x();
  message.y = p.y();
  message.z = p.z();
  return message;
}

}  // namespace

Pose toPose(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  const auto& t = transform.translation;
  return {Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(), Eigen::Vector3d(t.x, t.y, t.z)};
}

geometry_msgs::Transform toTransformMessage(const Pose& T) {
  geometry_msgs::Transform message;
  message.translation = toCoordinates<geometry_msgs::Vector3>(T.translation);
  message.rotation = toQuaternionMessage(T.rotation);
  return message;
}

geometry_msgs::Pose toPoseMessage(const Pose& T) {
  geometry_msgs::Pose message;
  message.position = toCoordinates<geometry_msgs::Point>(T.translation);
  message.orientation = toQuaternionMessage(T.rotation);
  return message;
}

}  // namespace revisit_slam
