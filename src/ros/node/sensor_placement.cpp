// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/sensor_placement.h"

#include <ros/console.h>

#include "revisit_slam/ros/messages/connected_frames.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

/// What a change of a transform has to exceed to be one.
constexpr double kSmallestShift = 1e-3;  // m
constexpr double kSmallestTurn = 1e-3;   // rad

bool differ(const Pose& a, const Pose& b) {
  const Pose change = a.inverse() * b;
  return change.translation.norm() > kSmallestShift || change.angle() > kSmallestTurn;
}

}  // namespace

void SensorPlacement::restart() {
  base_frame_ = given_base_frame_;
  placed_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  missing_.reset();
}

std::optional<Pose> SensorPlacement::find(const std::string& frame,
                                          const std::function<bool()>& stopping) {
  const std::string sensor_frame = withoutLeadingSlash(frame);
  if (base_frame_.empty()) base_frame_ = sensor_frame;
  const auto known = placed_.find(sensor_frame);
  if (known == placed_.end()) return placed_[sensor_frame] = waitFor(sensor_frame, stopping);
  const std::optional<Pose> T_base_sensor = lookUp(sensor_frame);
  if (!T_base_sensor) {
    noteMissing(sensor_frame);
    ROS_WARN_THROTTLE(5.0, "a message was dropped: %s", fault().c_str());
    return std::nullopt;
  }
  noteFound(sensor_frame);
  if (known->second && differ(*known->second, *T_base_sensor))
    ROS_WARN_THROTTLE(
        5.0, "the transform from '%s' to '%s' has changed: scans are placed by the new one",
        sensor_frame.c_str(), base_frame_.c_str());
  return known->second = T_base_sensor;
}

std::string SensorPlacement::parentOfBase(const std::string& own_parent) const {
  std::string parent;
  if (!buffer_._getParent(base_frame_, ros::Time(0), parent) || parent == own_parent) return "";
  return parent;
}

std::optional<Pose> SensorPlacement::lookUp(const std::string& sensor_frame) const {
  if (sensor_frame == base_frame_) return Pose::identity();
  try {
    return toPose(buffer_.lookupTransform(base_frame_, sensor_frame, ros::Time(0)).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<Pose> SensorPlacement::waitFor(const std::string& sensor_frame,
                                             const std::function<bool()>& stopping) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(patience_);
  std::optional<Pose> T_base_sensor = lookUp(sensor_frame);
  while (!T_base_sensor && !stopping() && ros::WallTime::now() < end) {
    noteMissing(sensor_frame);
    ROS_WARN_THROTTLE(5.0, "waiting for the transform from '%s' to '%s'; scans wait too. %s",
                      sensor_frame.c_str(), base_frame_.c_str(), fault().c_str());
    ros::WallDuration(0.05).sleep();
    T_base_sensor = lookUp(sensor_frame);
  }
  if (T_base_sensor) noteFound(sensor_frame);
  return T_base_sensor;
}

void SensorPlacement::noteMissing(const std::string& sensor_frame) {
  const std::lock_guard<std::mutex> lock(mutex_);
  missing_ = {base_frame_, sensor_frame};
}

void SensorPlacement::noteFound(const std::string& sensor_frame) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (missing_ && missing_->sensor_frame == sensor_frame) missing_.reset();
}

std::string SensorPlacement::fault() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!missing_) return "";
  const auto& [base_frame, sensor_frame] = *missing_;
  if (sensor_frame.empty())
    return "their header has no frame_id: let the driver set it, or start with base_frame:=none";
  const std::string connected = listOf(framesConnectedWith(sensor_frame, buffer_));
  return "TF has no transform from '" + sensor_frame + "' to '" + base_frame +
         "': broadcast it, here with the sensor at the origin of the robot, by: rosrun tf2_ros "
         "static_transform_publisher 0 0 0 0 0 0 " +
         base_frame + " " + sensor_frame +
         (connected.empty()
              ? ""
              : "; or set base_frame to a frame that it is connected with: " + connected) +
         "; or do without one: base_frame:=none";
}

}  // namespace revisit_slam
