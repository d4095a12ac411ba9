// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/motion_reader.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "revisit_slam/geometry/local_enu.h"
#include "revisit_slam/priors/gnss_track.h"
#include "revisit_slam/priors/motion_priors.h"
#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam {
namespace {

MotionReader::Result rejected(const char* sensor, const std::string& reason) {
  return {std::nullopt, sensor, reason};
}

/// m. No robot is as large: what is farther from its base is placed in another frame.
constexpr double kLongestLever = 100.0;
constexpr const char* kTooFar = "more than 100 m from the base frame: a wrong transform";

bool isTooFar(const Pose& T_base_sensor) {
  return T_base_sensor.translation.norm() > kLongestLever;
}

bool isUsable(const geometry_msgs::Pose& pose) {
  const auto& [p, q] = std::tie(pose.position, pose.orientation);
  const double norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return std::isfinite(p.x + p.y + p.z) && std::abs(norm - 1.0) < 0.1;
}

Pose toPose(const geometry_msgs::Pose& pose) {
  const auto& [p, q] = std::tie(pose.position, pose.orientation);
  return {Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(), {p.x, p.y, p.z}};
}

Eigen::Vector3d toVector(const geometry_msgs::Vector3& v) {
  return {v.x, v.y, v.z};
}

template <typename Values>
bool areFinite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

/// Row by row; all zeros or a variance below zero: not known.
template <int kSize, typename Values>
std::optional<Eigen::Matrix<double, kSize, kSize>> toCovariance(const Values& values) {
  using Matrix = Eigen::Matrix<double, kSize, kSize>;
  const Matrix covariance = Eigen::Map<const Matrix>(values.data());
  const bool is_known = covariance.allFinite() && !covariance.isZero(0.0) &&
                        (covariance.diagonal().array() >= 0.0).all();
  if (!is_known) return std::nullopt;
  return Matrix(0.5 * (covariance + covariance.transpose()));
}

}  // namespace

std::optional<MotionReader::Result> MotionReader::read(const MotionMessage& message) {
  if (const auto* odometry = std::get_if<nav_msgs::Odometry::ConstPtr>(&message))
    return readOdometry(**odometry);
  if (const auto* imu = std::get_if<sensor_msgs::Imu::ConstPtr>(&message)) return readImu(**imu);
  if (const auto* position = std::get_if<sensor_msgs::NavSatFix::ConstPtr>(&message))
    return readPosition(**position);
  return readTransforms(*std::get<tf2_msgs::TFMessage::ConstPtr>(message));
}

/// The axes of ROS covariances are ours: x, y, z, rotations about them, in the child frame.
MotionReader::Result MotionReader::readOdometry(const nav_msgs::Odometry& message) const {
  const char* sensor = MotionPriors::kOdometry;
  const geometry_msgs::Pose& pose = message.pose.pose;
  if (!isUsable(pose)) return rejected(sensor, "not a pose");
  if (message.header.stamp.isZero()) return rejected(sensor, "no stamp");
  if (message.child_frame_id.empty()) return rejected(sensor, "no child_frame_id");
  const std::optional<Pose> T_base_child = find_extrinsics_(message.child_frame_id);
  if (!T_base_child) return rejected(sensor, "no transform from '" + message.child_frame_id + "'");
  if (isTooFar(*T_base_child)) return rejected(sensor, kTooFar);
  OdometryReading reading;
  reading.stamp = toStamp(message.header.stamp);
  reading.T_world_base = toPose(pose) * T_base_child->inverse();
  reading.is_planar =
      pose.position.z == 0.0 && pose.orientation.x == 0.0 && pose.orientation.y == 0.0;
  if (const auto covariance = toCovariance<6>(message.twist.covariance)) {
    const Matrix6 A = adjoint(*T_base_child);
    reading.velocity_covariance = A * *covariance * A.transpose();
  }
  return {reading, sensor, ""};
}

/// A covariance that begins with -1: there is no turn rate, or no acceleration (sensor_msgs/Imu).
MotionReader::Result MotionReader::readImu(const sensor_msgs::Imu& message) const {
  const char* sensor = MotionPriors::kGyro;
  const Eigen::Vector3d turn_rate = toVector(message.angular_velocity);
  if (!turn_rate.allFinite() || message.angular_velocity_covariance[0] == -1.0)
    return rejected(sensor, "no turn rate");
  if (message.header.stamp.isZero()) return rejected(sensor, "no stamp");
  if (message.header.frame_id.empty()) return rejected(sensor, "no frame_id");
  const std::optional<Pose> T_base_imu = find_extrinsics_(message.header.frame_id);
  if (!T_base_imu) return rejected(sensor, "no transform from '" + message.header.frame_id + "'");
  if (isTooFar(*T_base_imu)) return rejected(sensor, kTooFar);
  ImuReading reading;
  reading.stamp = toStamp(message.header.stamp);
  reading.turn_rate = T_base_imu->rotation * turn_rate;
  if (const auto covariance = toCovariance<3>(message.angular_velocity_covariance))
    reading.turn_rate_variance = covariance->trace() / 3.0;
  const Eigen::Vector3d acceleration = toVector(message.linear_acceleration);
  const bool has_acceleration = acceleration.allFinite() && !acceleration.isZero(0.0) &&
                                message.linear_acceleration_covariance[0] != -1.0;
  if (has_acceleration) reading.acceleration = T_base_imu->rotation * acceleration;
  reading.p_base = T_base_imu->translation;
  return {reading, sensor, ""};
}

/// Covariances of NavSatFix are along east, north and up.
MotionReader::Result MotionReader::readPosition(const sensor_msgs::NavSatFix& message) const {
  const char* sensor = GnssTrack::kSensor;
  if (message.status.status < sensor_msgs::NavSatStatus::STATUS_FIX)
    return rejected(sensor, "no fix");
  GnssReading reading;
  reading.position = {message.latitude, message.longitude, message.altitude};
  if (!isValid(reading.position)) return rejected(sensor, "not a position");
  if (message.header.stamp.isZero()) return rejected(sensor, "no stamp");
  reading.stamp = toStamp(message.header.stamp);
  if (antenna_base_) {
    reading.p_base = *antenna_base_;
  } else {
    if (message.header.frame_id.empty()) return rejected(sensor, "no frame_id");
    const std::optional<Pose> T_base_antenna = find_extrinsics_(message.header.frame_id);
    if (!T_base_antenna)
      return rejected(sensor, "no transform from '" + message.header.frame_id + "'");
    reading.p_base = T_base_antenna->translation;
  }
  if (reading.p_base.norm() > kLongestLever) return rejected(sensor, kTooFar);
  const bool is_known =
      message.position_covariance_type != sensor_msgs::NavSatFix::COVARIANCE_TYPE_UNKNOWN;
  if (is_known && !areFinite(message.position_covariance))
    return rejected(sensor, "covariance not finite");
  const auto covariance = toCovariance<3>(message.position_covariance);
  reading.covariance_enu = covarianceOf(is_known ? covariance : std::nullopt);
  return {reading, sensor, ""};
}

/// Of a position whose message has this one; receivers may leave out that of the height.
Eigen::Matrix3d MotionReader::covarianceOf(const std::optional<Eigen::Matrix3d>& told) const {
  constexpr double vertical = 4.0;  // times the horizontal variance
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  if (told && told->diagonal().head<2>().minCoeff() > 0.0) {
    covariance = *told;
    if (covariance(2, 2) == 0.0)
      covariance(2, 2) = vertical * covariance.diagonal().head<2>().maxCoeff();
    return covariance;
  }
  covariance.diagonal() << 1.0, 1.0, vertical;
  return gnss_.unknown_deviation * gnss_.unknown_deviation * covariance;
}

std::optional<MotionReader::Result> MotionReader::readTransforms(
    const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (withoutLeadingSlash(transform.header.frame_id) != odometry_frame_) continue;
    if (child_frame_.empty()) child_frame_ = transform.child_frame_id;
    if (transform.child_frame_id != child_frame_) continue;
    nav_msgs::Odometry odometry;
    odometry.header = transform.header;
    odometry.child_frame_id = transform.child_frame_id;
    odometry.pose.pose.position.x = transform.transform.translation.x;
    odometry.pose.pose.position.y = transform.transform.translation.y;
    odometry.pose.pose.position.z = transform.transform.translation.z;
    odometry.pose.pose.orientation = transform.transform.rotation;
    return readOdometry(odometry);
  }
  return std::nullopt;
}

}  // namespace revisit_slam
