// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/node/map_broadcaster.h"

#include <algorithm>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {

MapBroadcaster::MapBroadcaster(const FramesConfig& frames, const LiveConfig& live)
    : frames_(frames),
      live_(live),
      robot_odometry_(live.broadcast_odom ? nullptr
                                          : std::make_unique<RobotOdometry>(frames.odom)) {}

void MapBroadcaster::onScan(const RegisteredScan& scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool anew = scan.id.session != session_;
  if (anew) {
    is_placed_ = scan.goes_on_from == nullptr;
    T_earth_map_.reset();
  }
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
  const bool is_placed = correction.places(correction.session);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (correction.session != session_) return;
  is_placed_ = is_placed;
  T_map_odom_ = correction.T_map_odom;
  tieToEarthLocked(correction.georeference);
  broadcastLocked(true);
}

void MapBroadcaster::tieToEarth(const std::optional<Georeference>& georeference) {
  const std::lock_guard<std::mutex> lock(mutex_);
  tieToEarthLocked(georeference);
}

void MapBroadcaster::tieToEarthLocked(const std::optional<Georeference>& georeference) {
  T_earth_map_.reset();
  if (georeference)
    T_earth_map_ = LocalEnu(georeference->datum).T_ecef_enu() * georeference->T_enu_map;
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
  if (!session_ || !is_placed_) return;
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
  const std::vector<geometry_msgs::TransformStamped> transforms = transformsLocked(stamp);
  if (transforms.empty()) return;
  last_broadcast_ = stamp;
  last_sent_ = now;
  broadcaster_.sendTransform(transforms);
}

std::vector<geometry_msgs::TransformStamped> MapBroadcaster::transformsLocked(Stamp stamp) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  const auto add = [&](const std::string& parent, const std::string& child, const Pose& T) {
    geometry_msgs::TransformStamped& message = transforms.emplace_back();
    message.header.stamp = toRosTime(stamp);
    message.header.frame_id = parent;
    message.child_frame_id = child;
    message.transform = toTransformMessage(T);
  };
  if (T_earth_map_ && !frames_.earth.empty()) add(frames_.earth, frames_.map, *T_earth_map_);
  if (!live_.broadcast_map) return transforms;
  const std::optional<Pose> T_own_robot =
      robot_odometry_ ? robot_odometry_->placed() : Pose::identity();
  if (T_own_robot) add(frames_.map, frames_.odom, T_map_odom_ * *T_own_robot);
  return transforms;
}

}  // namespace revisit_slam
