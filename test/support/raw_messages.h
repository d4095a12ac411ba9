// SPDX-License-Identifier: MIT
#pragma once

#include <ros/serialization.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "support/point_cloud_builder.h"

namespace revisit_slam {

constexpr const char* livox_md5sum = "e4d6829bdfe657cb6c21a746c86b21a6";

/// The types and names of CustomMsg, as ROS sends them along with the first message.
constexpr const char* livox_definition =
    "# Livox publish pointcloud msg format.\n"
    "std_msgs/Header header\nuint64 timebase # of the first point\nuint32 point_num\n"
    "uint8 lidar_id\nuint8[3] rsvd\nCustomPoint[] points\n"
    "================\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
    "================\nMSG: livox_ros_driver2/CustomPoint\n"
    "uint32 offset_time\nfloat32 x\nfloat32 y\nfloat32 z\nuint8 reflectivity\nuint8 tag\nuint8 "
    "line\n";

/// The times of the points are nanoseconds since the timebase.
inline std::vector<std::uint8_t> livoxBytes(std::int64_t header_ns, std::int64_t timebase_ns,
                                            const std::vector<TestPoint>& points) {
  std::vector<std::uint8_t> bytes(1024 + 19 * points.size());
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  out.next(std::uint32_t{7});
  out.next(static_cast<std::uint32_t>(header_ns / 1'000'000'000));
  out.next(static_cast<std::uint32_t>(header_ns % 1'000'000'000));
  out.next(std::string("livox_frame"));
  out.next(static_cast<std::uint64_t>(timebase_ns));
  out.next(static_cast<std::uint32_t>(points.size()));
  for (int i = 0; i < 4; ++i) out.next(std::uint8_t{0});
  out.next(static_cast<std::uint32_t>(points.size()));
  for (const TestPoint& p : points) {
    out.next(static_cast<std::uint32_t>(p.time));
    for (const double value : {p.x, p.y, p.z}) out.next(static_cast<float>(value));
    for (const int value : {100, 0x10, 3}) out.next(static_cast<std::uint8_t>(value));
  }
  bytes.resize(bytes.size() - out.getLength());
  return bytes;
}

inline topic_tools::ShapeShifter shapeShifter(std::vector<std::uint8_t> bytes,
                                              const std::string& datatype,
                                              const std::string& md5sum = livox_md5sum,
                                              const std::string& definition = livox_definition) {
  topic_tools::ShapeShifter message;
  message.morph(md5sum, datatype, definition, "0");
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.read(in);
  return message;
}

/// Any message as it is sent.
template <typename Message>
std::vector<std::uint8_t> bytesOf(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
  return bytes;
}

/// Bytes that claim to be a message of this type.
template <typename Message>
topic_tools::ShapeShifter claiming(std::vector<std::uint8_t> bytes) {
  return shapeShifter(std::move(bytes), ros::message_traits::datatype<Message>(),
                      ros::message_traits::md5sum<Message>(),
                      ros::message_traits::definition<Message>());
}

/// The bytes of this cloud, but for the length of its data, which is said to be 4e9.
inline std::vector<std::uint8_t> bytesThatAnnounceMore(const sensor_msgs::PointCloud2& cloud) {
  std::vector<std::uint8_t> bytes = bytesOf(cloud);
  const std::uint32_t announced = 4'000'000'000;
  std::memcpy(&bytes[bytes.size() - cloud.data.size() - 5], &announced, sizeof(announced));
  return bytes;
}

}  // namespace revisit_slam
