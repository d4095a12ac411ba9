// SPDX-License-Identifier: MIT
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>
#include <vector>

#include "revisit_slam/input/sweep_merger.h"
#include "revisit_slam/priors/prior_account.h"
#include "revisit_slam/types/informed_scan.h"
#include "revisit_slam/types/scan_account.h"

namespace revisit_slam {

geometry_msgs::TransformStamped toTransform(const RegisteredScan& scan,
                                            const std::string& odom_frame,
                                            const std::string& base_frame);

/// Pose in the odom frame, twist in the base frame; the covariances are not filled in.
nav_msgs::Odometry toOdometry(const RegisteredScan& scan, const std::string& odom_frame,
                              const std::string& base_frame);

/// Covariances (36 values, row by row) in the order and axes of ROS: of the pose in the odom frame,
/// of the twist in the base frame. `covariance_pose` and `covariance_motion` are for right
/// perturbations; the motion took `seconds`.
void fillCovariances(const Matrix6& covariance_pose, const Matrix6& covariance_motion,
                     double seconds, const Pose& T_odom_base, nav_msgs::Odometry& odometry);

/// With the covariances of pose and motion; those of a session's first scan are not filled in.
nav_msgs::Odometry toOdometry(const InformedScan& informed, const std::string& odom_frame,
                              const std::string& base_frame);

/// An arrow at the base for every weak direction: red for translation, blue for rotation. The first
/// marker deletes those of the scan before.
visualization_msgs::MarkerArray toMarkers(const std::vector<WeakDirection>& weak_directions,
                                          Stamp stamp, const std::string& base_frame);

/// Fields x, y, z.
sensor_msgs::PointCloud2 toPointCloud(const Points& points, Stamp stamp, const std::string& frame);

/// received, processed and every reason of dropping as key and value.
void addAccount(const ScanAccount& account, diagnostic_msgs::DiagnosticStatus& status);
/// Likewise of each sensor that measures motion.
void addPriors(const std::map<std::string, PriorAccount>& accounts,
               diagnostic_msgs::DiagnosticStatus& status);
/// Of several LiDARs, by topic; a silent one is a warning.
void addLidars(const std::map<std::string, SensorAccount>& accounts,
               diagnostic_msgs::DiagnosticStatus& status);
/// Each weak direction, [translation; rotation], with its eigenvalue.
void addWeakDirections(const std::vector<WeakDirection>& weak_directions,
                       diagnostic_msgs::DiagnosticStatus& status);
void addValue(const std::string& key, const std::string& value,
              diagnostic_msgs::DiagnosticStatus& status);

}  // namespace revisit_slam
