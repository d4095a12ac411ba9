// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/scan_messages.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "revisit_slam/information/motion_covariance.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

template <typename Vector>
std::string onOneLine(const Vector& vector) {
  std::ostringstream text;
  text << vector.transpose().format(Eigen::IOFormat(3, Eigen::DontAlignCols, " ", " "));
  return text.str();
}

}  // namespace

geometry_msgs::TransformStamped toTransform(const RegisteredScan& scan,
                                            const std::string& odom_frame,
                                            const std::string& base_frame) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = toRosTime(scan.stamp);
  message.header.frame_id = odom_frame;
  message.child_frame_id = base_frame;
  message.transform = toTransformMessage(scan.T_odom_base);
  return message;
}

nav_msgs::Odometry toOdometry(const RegisteredScan& scan, const std::string& odom_frame,
                              const std::string& base_frame) {
  nav_msgs::Odometry message;
  message.header.stamp = toRosTime(scan.stamp);
  message.header.frame_id = odom_frame;
  message.child_frame_id = base_frame;
  message.pose.pose = toPoseMessage(scan.T_odom_base);
  const Tangent& v = scan.velocity_base;
  message.twist.twist.linear.x = v[0];
  message.twist.twist.linear.y = v[1];
  message.twist.twist.linear.z = v[2];
  message.twist.twist.angular.x = v[3];
  message.twist.twist.angular.y = v[4];
  message.twist.twist.angular.z = v[5];
  return message;
}

void fillCovariances(const Matrix6& covariance_pose, const Matrix6& covariance_motion,
                     double seconds, const Pose& T_odom_base, nav_msgs::Odometry& odometry) {
  using RowMajor6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  Eigen::Map<RowMajor6>(odometry.pose.covariance.data()) =
      inFixedAxes(covariance_pose, T_odom_base);
  if (seconds > 0.0)
    Eigen::Map<RowMajor6>(odometry.twist.covariance.data()) =
        covariance_motion / (seconds * seconds);
}

nav_msgs::Odometry toOdometry(const InformedScan& informed, const std::string& odom_frame,
                              const std::string& base_frame) {
  const RegisteredScan& scan = *informed.scan;
  nav_msgs::Odometry message = toOdometry(scan, odom_frame, base_frame);
  if (scan.id.value > 0)
    fillCovariances(informed.covariance_pose, informed.covariance_motion,
                    scan.seconds_since_previous, scan.T_odom_base, message);
  return message;
}

visualization_msgs::MarkerArray toMarkers(const std::vector<WeakDirection>& weak_directions,
                                          Stamp stamp, const std::string& base_frame) {
  constexpr double kLength = 5.0, kShaft = 0.2, kHead = 0.5;  // m
  visualization_msgs::MarkerArray array;
  array.markers.resize(1);
  array.markers[0].action = visualization_msgs::Marker::DELETEALL;
  for (const WeakDirection& weak : weak_directions) {
    const bool rotation = weak.direction.head<3>().isZero();
    const Eigen::Vector3d tip =
        kLength * (rotation ? weak.direction.tail<3>() : weak.direction.head<3>());
    visualization_msgs::Marker arrow;
    arrow.header.stamp = toRosTime(stamp);
    arrow.header.frame_id = base_frame;
    arrow.ns = "weak_directions";
    arrow.id = static_cast<int>(array.markers.size());
    arrow.type = visualization_msgs::Marker::ARROW;
    arrow.pose.orientation.w = 1.0;
    arrow.points.resize(2);
    arrow.points[1].x = tip.x();
    arrow.points[1].y = tip.y();
    arrow.points[1].z = tip.z();
    arrow.scale.x = kShaft;
    arrow.scale.y = kHead;
    arrow.color.a = 1.0;
    (rotation ? arrow.color.b : arrow.color.r) = 1.0;
    array.markers.push_back(arrow);
  }
  return array;
}

sensor_msgs::PointCloud2 toPointCloud(const Points& points, Stamp stamp, const std::string& frame) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = toRosTime(stamp);
  cloud.header.frame_id = frame;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  for (const char* axis : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = axis;
    field.offset = static_cast<std::uint32_t>(cloud.fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
  }
  static_assert(sizeof(Points::value_type) == 3 * sizeof(float), "points are copied as they lie");
  cloud.point_step = sizeof(Points::value_type);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = 1;
  cloud.data.resize(cloud.row_step);
  if (!points.empty()) std::memcpy(cloud.data.data(), points.data(), cloud.data.size());
  return cloud;
}

void addAccount(const ScanAccount& account, diagnostic_msgs::DiagnosticStatus& status) {
  addValue("scans received", std::to_string(account.received), status);
  addValue("scans processed", std::to_string(account.processed), status);
  addValue("scans at rest, not mapped", std::to_string(account.at_rest), status);
  addValue("messages joined to sweeps", std::to_string(account.joined), status);
  for (const auto& [reason, count] : account.dropped)
    addValue("scans dropped, " + reason, std::to_string(count), status);
  for (const auto& [reason, count] : account.points_dropped)
    addValue("points dropped, " + reason, std::to_string(count), status);
}

namespace {

/// Why most of the messages that came could not be used.
std::string mostDropped(const PriorAccount& account) {
  const auto most =
      std::max_element(account.dropped.begin(), account.dropped.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == account.dropped.end()) return "";
  return " that can be used (" + std::to_string(most->second) + " of " +
         std::to_string(account.received) + ": " + most->first + ")";
}

/// What is amiss with the clock or the driver of a sensor that sends.
std::string lateness(const std::string& topic, const SensorAccount& account) {
  char seconds[32];
  std::snprintf(seconds, sizeof(seconds), "%.3g", std::abs(account.behind));
  return ", scans on " + topic + " are left out: their stamps are " + seconds + " s " +
         (account.behind > 0.0 ? "behind" : "ahead of") +
         " those of others (correct input/time_offsets, or raise input/max_wait)";
}

}  // namespace

void addPriors(const std::map<std::string, PriorAccount>& accounts,
               diagnostic_msgs::DiagnosticStatus& status) {
  for (const auto& [sensor, account] : accounts) {
    addValue(sensor + " messages received", std::to_string(account.received), status);
    for (const auto& [reason, count] : account.dropped)
      addValue(sensor + " messages dropped: " + reason, std::to_string(count), status);
    addValue(sensor + " used in scans", std::to_string(account.used), status);
    addValue(sensor + " rejected in scans", std::to_string(account.rejected), status);
    addValue(sensor + " missing in scans", std::to_string(account.missing), status);
    if (account.scale) addValue(sensor + " scale", std::to_string(*account.scale), status);
    if (account.bias) addValue(sensor + " bias, rad/s", onOneLine(*account.bias), status);
    if (!account.is_silent) continue;
    if (status.level == status.OK) status.level = status.WARN;
    status.message += ", no messages of " + sensor + mostDropped(account);
  }
}

void addLidars(const std::map<std::string, SensorAccount>& accounts,
               diagnostic_msgs::DiagnosticStatus& status) {
  for (const auto& [topic, account] : accounts) {
    addValue(topic + " messages", std::to_string(account.messages), status);
    addValue(topic + " points in sweeps", std::to_string(account.points), status);
    for (const auto& [reason, count] : account.points_dropped)
      addValue(topic + " points dropped: " + reason, std::to_string(count), status);
    if (!account.is_silent && !account.is_late) continue;
    if (status.level == status.OK) status.level = status.WARN;
    status.message += account.is_silent ? ", no scans on " + topic : lateness(topic, account);
  }
}

void addWeakDirections(const std::vector<WeakDirection>& weak_directions,
                       diagnostic_msgs::DiagnosticStatus& status) {
  for (const WeakDirection& weak : weak_directions)
    addValue("weak direction, eigenvalue " + std::to_string(weak.eigenvalue),
             onOneLine(weak.direction), status);
}

void addValue(const std::string& key, const std::string& value,
              diagnostic_msgs::DiagnosticStatus& status) {
  diagnostic_msgs::KeyValue entry;
  entry.key = key;
  entry.value = value;
  status.values.push_back(entry);
}

}  // namespace revisit_slam
