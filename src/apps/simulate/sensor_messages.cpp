// SPDX-License-Identifier: MIT
#include "sensor_messages.h"

#include <tf2_msgs/TFMessage.h>

#include <boost/make_shared.hpp>
#include <limits>

#include "revisit_slam/ros/messages/pose_conversions.h"

namespace revisit_slam::simulation {
namespace {

geometry_msgs::TransformStamped mounting(const std::string& frame, const Pose& T_base_sensor,
                                         Stamp start) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = toRosTime(start);
  transform.header.frame_id = "base_link";
  transform.child_frame_id = frame;
  transform.transform = toTransformMessage(T_base_sensor);
  return transform;
}

}  // namespace

void writeMountings(rosbag::Bag& bag, const Options& o, Stamp start) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(mounting("lidar", o.scan.T_base_sensor, start));
  for (const FurtherSensor& sensor : o.further)
    message.transforms.push_back(
        mounting("lidar_" + std::to_string(sensor.number), sensor.T_base_sensor, start));
  if (o.with_imu) message.transforms.push_back(mounting("imu", o.imu.T_base_imu, start));
  if (o.with_gnss)
    message.transforms.push_back(
        mounting("gnss", {Eigen::Quaterniond::Identity(), o.gnss.p_base_antenna}, start));
  auto connection = boost::make_shared<ros::M_string>();
  using Traits = ros::message_traits::MD5Sum<tf2_msgs::TFMessage>;
  (*connection)["topic"] = "/tf_static";
  (*connection)["type"] = ros::message_traits::datatype<tf2_msgs::TFMessage>();
  (*connection)["md5sum"] = Traits::value();
  (*connection)["message_definition"] = ros::message_traits::definition<tf2_msgs::TFMessage>();
  (*connection)["callerid"] = "/simulate";
  (*connection)["latching"] = "1";
  bag.write("/tf_static", toRosTime(start), message, connection);
}

nav_msgs::Odometry messageOf(const WheelReading& reading) {
  nav_msgs::Odometry message;
  message.header.stamp = toRosTime(reading.stamp);
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose = toPoseMessage(reading.T_odom_base);
  message.twist.twist.linear.x = reading.velocity_base[0];
  message.twist.twist.angular.z = reading.velocity_base[5];
  return message;
}

sensor_msgs::Imu messageOf(const ImuSample& sample) {
  sensor_msgs::Imu message;
  message.header.stamp = toRosTime(sample.stamp);
  message.header.frame_id = "imu";
  message.orientation_covariance[0] = -1.0;  // it gives none
  message.angular_velocity.x = sample.turn_rate_imu.x();
  message.angular_velocity.y = sample.turn_rate_imu.y();
  message.angular_velocity.z = sample.turn_rate_imu.z();
  message.linear_acceleration.x = sample.acceleration_imu.x();
  message.linear_acceleration.y = sample.acceleration_imu.y();
  message.linear_acceleration.z = sample.acceleration_imu.z();
  return message;
}

sensor_msgs::NavSatFix messageOf(const GnssSample& sample) {
  sensor_msgs::NavSatFix message;
  message.header.stamp = toRosTime(sample.stamp);
  message.header.frame_id = "gnss";
  message.status.service = sensor_msgs::NavSatStatus::SERVICE_GPS;
  if (!sample.has_position) {
    message.status.status = sensor_msgs::NavSatStatus::STATUS_NO_FIX;
    message.latitude = message.longitude = message.altitude =
        std::numeric_limits<double>::quiet_NaN();
    return message;
  }
  message.status.status = sensor_msgs::NavSatStatus::STATUS_FIX;
  message.latitude = sample.position.latitude;
  message.longitude = sample.position.longitude;
  message.altitude = sample.position.altitude;
  const double variance = sample.deviation * sample.deviation;
  message.position_covariance[0] = message.position_covariance[4] = variance;
  message.position_covariance[8] = 4.0 * variance;
  message.position_covariance_type = sensor_msgs::NavSatFix::COVARIANCE_TYPE_DIAGONAL_KNOWN;
  return message;
}

}  // namespace revisit_slam::simulation
