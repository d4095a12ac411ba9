// SPDX-License-Identifier: MIT
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "revisit_slam/ros/node/robot_odometry.h"
#include "revisit_slam/slam/slam_config.h"
#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/map_correction.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

/// Broadcasts where the odometry frame is in the map: our own or, where live/broadcast_odom is
/// false, that of the robot, T_map_odom = T_map_base * T_odom_base^-1 at the stamp of a scan. Time
/// runs on a little from the newest scan, whatever clock its stamps are from. Where the map lies on
/// the earth is broadcast with it, if that is known and frames/earth is named. May be used from any
/// thread; none waits for another for long.
class MapBroadcaster {
 public:
  MapBroadcaster(const FramesConfig& frames, const LiveConfig& live);

  /// A scan has come. One of another session puts the odometry frame back to the map's origin;
  /// where it goes on from a map nobody knows where that is, and nothing is broadcast until it is.
  void onScan(const RegisteredScan& scan);
  /// The same, where it is known with the scan where the odometry frame is.
  void place(const RegisteredScan& scan, const Pose& T_map_odom);
  /// Broadcasts a correction at once, unless it is of another session.
  void correct(const MapCorrection& correction);
  /// Where the map lies on the earth, until a session begins on a map of its own; none: not known.
  void tieToEarth(const std::optional<Georeference>& georeference);
  /// Nothing is known any longer, until a scan comes.
  void forget();
  /// Nothing before the first scan, nor twice for the same time: without new scans once a second,
  /// a microsecond later each.
  void broadcast();

 private:
  void tieToEarthLocked(const std::optional<Georeference>& georeference);
  void takeLocked(const RegisteredScan& scan, const Pose& T_map_odom);
  void broadcastLocked(bool at_once);
  std::vector<geometry_msgs::TransformStamped> transformsLocked(Stamp stamp);

  const FramesConfig frames_;
  const LiveConfig live_;
  tf2_ros::TransformBroadcaster broadcaster_;

  std::mutex mutex_;  // guards what follows
  std::optional<SessionId> session_;
  bool is_placed_ = true;                          // it is known where the session lies in the map
  Pose T_map_odom_;                                // of our own odometry
  std::unique_ptr<RobotOdometry> robot_odometry_;  // null: there is only our own
  std::optional<Pose> T_earth_map_;
  Stamp newest_scan_;
  ros::Time newest_arrival_;
  Stamp last_broadcast_;
  ros::WallTime last_sent_;
};

}  // namespace revisit_slam
