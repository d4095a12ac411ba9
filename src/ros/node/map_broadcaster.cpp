// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/map_broadcaster.h"

#include <algorithm>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/types/session_groups.h"

namespace revisit_slam {

MapBroadcaster::MapBroadcaster(const FramesConfig& frames, const LiveConfig& live)
    : frames_(frames),
      live_(live),
      robot_odometry_(live.broadcast_odom ? nullptr
                                          : std::make_unique<RobotOdometry>(frames.odom)) {}

void MapBroadcaster::onScan(const RegisteredScan& scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool anew = scan.id.session != session_;
  if (anew) is_placed_ = scan.goes_on_from == nullptr;
  takeLocked(scan, anew ? Pose::identity() : T_map_odom_);
}

void MapBroadcaster::place(const RegisteredScan& scan, const Pose& T_map_odom) {
  const std::lock_guard<std::mutex> lock(mutex_);
  takeLocked(scan, T_map_odom);
}

void MapBroadcaster::takeLocked(const RegisteredScan& scan, const Pose& T_map_odom) {
  const bool anew = scan.id.session != session_;
  const bool moves = anew || T_map_odom.translation != T_map_odom_.translation;
  if (anew) last_broadcast_ = {};
  session_ = scan.id.session;
  T_map_odom_ = T_map_odom;
  newest_scan_ = scan.stamp;
  newest_arrival_ = ros::Time::now();
  if (robot_odometry_) {
    if (anew) robot_odometry_->restart();
    robot_odometry_->onScan(scan.stamp, scan.T_odom_base,
                            frames_.base.empty() ? scan.sensor_frame : frames_.base);
  }
  if (moves) broadcastLocked(true);
}

void MapBroadcaster::correct(const MapCorrection& correction) {
  const SessionId session = correction.session;
  const bool is_tied = SessionGroups(correction.loops).of(session) != session;
  const bool is_alone = correction.begin.size() <= 1;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (session != session_) return;
  is_placed_ = is_alone || is_tied;
  T_map_odom_ = correction.T_map_odom;
  broadcastLocked(true);
}

void MapBroadcaster::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  session_.reset();
}

void MapBroadcaster::broadcast() {
  const std::lock_guard<std::mutex> lock(mutex_);
  broadcastLocked(false);
}

void MapBroadcaster::broadcastLocked(bool at_once) {
  if (!session_ || !is_placed_ || !live_.broadcast_map) return;
  Pose T_map_odom = T_map_odom_;
  if (robot_odometry_) {
    const std::optional<Pose> T_own_robot = robot_odometry_->placed();
    if (!T_own_robot) return;
    T_map_odom = T_map_odom_ * *T_own_robot;
  }
  // Not far ahead of scans that come late: what is dated ahead is what they are placed by.
  constexpr double kLongest = 0.2;  // s
  const double since_scan = std::clamp((ros::Time::now() - newest_arrival_).toSec(), 0.0, kLongest);
  Stamp stamp = newest_scan_.plusSeconds(since_scan + live_.transform_tolerance);
  // Once a second without new scans too, for those who begin to listen then.
  constexpr double kRest = 1.0;  // s
  const ros::WallTime now = ros::WallTime::now();
  if (stamp <= last_broadcast_) {
    if (!at_once && (now - last_sent_).toSec() < kRest) return;
    stamp = last_broadcast_.plusSeconds(1e-6);  // tf ignores a second one of the same time
  }
  last_broadcast_ = stamp;
  last_sent_ = now;
  geometry_msgs::TransformStamped message;
  message.header.stamp = toRosTime(stamp);
  message.header.frame_id = frames_.map;
  message.child_frame_id = frames_.odom;
  message.transform = toTransformMessage(T_map_odom);
  broadcaster_.sendTransform(message);
}

}  // namespace revisit_slam
