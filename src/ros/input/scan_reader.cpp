// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_reader.h"

#include <ros/serialization.h>

#include <cmath>
#include <exception>
#include <utility>

#include "revisit_slam/ros/input/point_fields.h"

namespace revisit_slam {
namespace {

constexpr const char* supported_types =
    "sensor_msgs/PointCloud2, livox_ros_driver/CustomMsg, livox_ros_driver2/CustomMsg";

bool isPointCloud2Layout(const topic_tools::ShapeShifter& message) {
  return message.getMD5Sum() == ros::message_traits::md5sum<sensor_msgs::PointCloud2>();
}

bool isLivoxLayout(const topic_tools::ShapeShifter& message) {
  return hasLivoxLayout(message.getMD5Sum(), message.getMessageDefinition());
}

ScanReading rejected(ScanRejection rejection, const std::string& detail) {
  ScanReading reading;
  reading.rejection = rejection;
  reading.detail = detail;
  return reading;
}

/// Turns what is thrown (damaged messages, no memory) into a rejection.
template <typename Read>
ScanReading withoutThrowing(ScanRejection rejection, Read read) {
  try {
    return read();
  } catch (const std::exception& error) {
    return rejected(rejection, error.what());
  }
}

std::vector<std::uint8_t> bytesOf(const topic_tools::ShapeShifter& message,
                                  std::vector<std::uint8_t> buffer) {
  buffer.resize(message.size());
  ros::serialization::OStream stream(buffer.data(), message.size());
  message.write(stream);
  return buffer;
}

/// The timebase where it is on the clock of the header stamps; a sensor without synchronisation
/// counts from its own start.
ReferenceStamp referenceOf(const LivoxCustomMsg& message, const ScanInputConfig& config) {
  const double apart = std::abs(message.timebase.toSeconds() - message.header_stamp.toSeconds());
  const bool by_header = config.time_origin == "relative" || config.header_stamp != "auto";
  const bool by_timebase = config.time_origin == "absolute" || (apart <= 1.0 && !by_header);
  if (by_timebase) return {message.timebase, "timebase", TimeUnit::ns};
  return {message.header_stamp, "header", TimeUnit::ns};
}

}  // namespace

ScanReader::ScanReader(const ScanInputConfig& config, const Pose& T_base_sensor)
    : config_(config), reader_(config), T_base_sensor_(T_base_sensor) {}

ScanReading ScanReader::read(const PointCloud& cloud) {
  return withoutThrowing(ScanRejection::internal_error, [&] {
    return readCloud({cloud.stamp, cloud.frame_id, viewOf(cloud)});
  });
}

ScanReading ScanReader::read(const sensor_msgs::PointCloud2& cloud) {
  return withoutThrowing(ScanRejection::internal_error, [&] { return readCloud(viewOf(cloud)); });
}

ScanReading ScanReader::read(const topic_tools::ShapeShifter& message) {
  return withoutThrowing(ScanRejection::bad_layout, [&] {
    const bool is_livox = isLivoxCustomMsg(message.getDataType());
    if (!is_livox && message.getDataType() != "sensor_msgs/PointCloud2") {
      return rejected(ScanRejection::unsupported_type,
                      "'" + message.getDataType() + "'; supported: " + supported_types);
    }
    if (!(is_livox ? isLivoxLayout(message) : isPointCloud2Layout(message))) {
      return rejected(
          ScanRejection::unsupported_type,
          message.getDataType() + " of an unknown layout, md5sum " + message.getMD5Sum());
    }
    bytes_ = bytesOf(message, std::move(bytes_));
    return is_livox ? readLivox(parseLivoxCustomMsg(bytes_)) : readCloud(parsePointCloud2(bytes_));
  });
}

ScanReading ScanReader::readCloud(const PointMessage& cloud) {
  return readPoints(cloud, {cloud.header_stamp, "header", {}});
}

ScanReading ScanReader::readLivox(const LivoxCustomMsg& message) {
  return readPoints(message, referenceOf(message, config_));
}

ScanReading ScanReader::readPoints(const PointMessage& message, const ReferenceStamp& reference) {
  ScanReading reading = reader_.read(message.points, reference);
  if (reading.scan) reading.scan->T_base_sensor = T_base_sensor_;
  reading.frame_id = message.frame_id;
  reading.header_stamp = message.header_stamp;
  return reading;
}

}  // namespace revisit_slam
