// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/scan_reader.h"

#include <ros/serialization.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "revisit_slam/ros/input/point_fields.h"

namespace revisit_slam {
namespace {

constexpr const char* supported_types =
    "sensor_msgs/PointCloud2, livox_ros_driver/CustomMsg, livox_ros_driver2/CustomMsg";

bool isPointCloud2Layout(const RawMessage& message) {
  return message.md5sum == ros::message_traits::md5sum<sensor_msgs::PointCloud2>();
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

/// The timebase where it is on the clock of the header stamps; a sensor without synchronisation
/// counts from its own start.
ReferenceStamp referenceOf(const LivoxCustomMsg& message, const ScanInputConfig& config) {
  const double apart = std::abs(message.timebase.toSeconds() - message.header_stamp.toSeconds());
  const bool by_header = config.time_origin == "relative" || config.header_stamp != "auto" ||
                         config.stamps == "arrival";
  const bool by_timebase = config.time_origin == "absolute" || (apart <= 1.0 && !by_header);
  if (by_timebase) return {message.timebase, "timebase", TimeUnit::ns};
  return {message.header_stamp, "header", TimeUnit::ns};
}

/// A message comes after its last point.
ScanInputConfig withInstantOfArrival(ScanInputConfig config) {
  if (config.stamps == "arrival" && config.header_stamp == "auto") config.header_stamp = "last";
  return config;
}

/// A header stamp that the driver has left zero gives all scans the same stamp, unless the times of
/// the points are absolute.
ScanReading refuseZeroStamp(ScanReading reading) {
  constexpr double most = 86'400.0;  // s after zero: no time of a clock that was ever set
  const bool has_time = reading.scan && reading.scan->stamp.toSeconds() > most;
  const bool is_other_fault = !reading.scan && reading.rejection != ScanRejection::bad_stamp;
  if (reading.header_stamp.nanoseconds != 0 || has_time || is_other_fault) return reading;
  reading.scan.reset();
  reading.rejection = ScanRejection::no_stamp;
  reading.detail =
      "the header stamp is zero; let the driver set it, or set input/stamps to arrival";
  return reading;
}

void copyBytes(const topic_tools::ShapeShifter& message, std::vector<std::uint8_t>& bytes) {
  bytes.resize(message.size());
  ros::serialization::OStream stream(bytes.data(), message.size());
  message.write(stream);
}

}  // namespace

std::string frameOf(const topic_tools::ShapeShifter& message) {
  try {
    std::vector<std::uint8_t> bytes;
    copyBytes(message, bytes);
    PointMessage read;
    MessageBytes(bytes).header(read);
    return read.frame_id;
  } catch (const std::exception&) {
    return "";
  }
}

ScanReader::ScanReader(const ScanInputConfig& config, const Pose& T_base_sensor)
    : config_(config), reader_(withInstantOfArrival(config)), T_base_sensor_(T_base_sensor) {}

ScanReading ScanReader::read(const PointCloud& cloud) {
  return withoutThrowing(ScanRejection::internal_error, [&] {
    return readCloud({cloud.stamp, cloud.frame_id, viewOf(cloud)});
  });
}

ScanReading ScanReader::read(const sensor_msgs::PointCloud2& cloud, Stamp arrival) {
  return withoutThrowing(ScanRejection::internal_error,
                         [&] { return readStampedCloud(viewOf(cloud), arrival); });
}

ScanReading ScanReader::read(const topic_tools::ShapeShifter& message, Stamp arrival) {
  return withoutThrowing(ScanRejection::bad_layout, [&] {
    raw_.arrival = arrival;
    raw_.datatype = message.getDataType();
    raw_.md5sum = message.getMD5Sum();
    raw_.definition = message.getMessageDefinition();
    copyBytes(message, raw_.bytes);
    return read(raw_);
  });
}

ScanReading ScanReader::read(const RawMessage& message) {
  return withoutThrowing(ScanRejection::bad_layout, [&] {
    const bool is_livox = isLivoxCustomMsg(message.datatype);
    if (!is_livox && message.datatype != "sensor_msgs/PointCloud2") {
      return rejected(ScanRejection::unsupported_type,
                      "'" + message.datatype + "'; supported: " + supported_types);
    }
    if (!(is_livox ? hasLivoxLayout(message.md5sum, message.definition)
                   : isPointCloud2Layout(message))) {
      return rejected(ScanRejection::unsupported_type,
                      message.datatype + " of an unknown layout, md5sum " + message.md5sum);
    }
    return is_livox
               ? readLivox(parseLivoxCustomMsg(message.bytes), message.arrival)
               : readStampedCloud(parsePointCloud2(MessageBytes(message.bytes)), message.arrival);
  });
}

ScanReading ScanReader::readCloud(const PointMessage& cloud) {
  return readPoints(cloud, {cloud.header_stamp, "header", {}});
}

ScanReading ScanReader::readStampedCloud(PointMessage cloud, Stamp arrival) {
  stampByArrival(cloud, arrival);
  return refuseZeroStamp(readCloud(cloud));
}

ScanReading ScanReader::readLivox(LivoxCustomMsg message, Stamp arrival) {
  stampByArrival(message, arrival);
  return refuseZeroStamp(readPoints(message, referenceOf(message, config_)));
}

void ScanReader::stampByArrival(PointMessage& message, Stamp arrival) const {
  if (config_.stamps == "arrival") message.header_stamp = arrival;
}

ScanReading ScanReader::readPoints(const PointMessage& message, const ReferenceStamp& reference) {
  ScanReading reading = reader_.read(message.points, reference);
  if (reading.scan) reading.scan->T_base_sensor = T_base_sensor_;
  reading.frame_id = message.frame_id;
  reading.header_stamp = message.header_stamp;
  return reading;
}

const ScanReader& toBeTold(const std::vector<ScanReader>& readers) {
  const auto found = std::find_if(readers.begin(), readers.end(), [](const ScanReader& reader) {
    return !reader.remedy().empty();
  });
  return found != readers.end() ? *found : readers.front();
}

}  // namespace revisit_slam
