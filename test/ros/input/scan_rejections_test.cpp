// SPDX-License-Identifier: MIT
// Messages that cannot be used: each gives its reason and none throws.
#include <gtest/gtest.h>

#include <limits>

#include "revisit_slam/ros/input/scan_reader.h"
#include "support/point_cloud_builder.h"
#include "support/raw_messages.h"

namespace revisit_slam {
namespace {

using Field = sensor_msgs::PointField;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <typename Message>
void expectRejected(const Message& message, ScanRejection rejection, const std::string& detail) {
  const ScanReading reading = ScanReader({}).read(message);
  EXPECT_FALSE(reading.scan);
  EXPECT_EQ(reading.rejection, rejection) << describe(reading.rejection);
  EXPECT_NE(reading.detail.find(detail), std::string::npos) << reading.detail;
}

sensor_msgs::PointCloud2 goodCloud() {
  return PointCloudBuilder().xyz().field("t", Field::UINT32).build(sweep(0, 99.8e6));
}

TEST(Rejections, noPoints) {
  expectRejected(sensor_msgs::PointCloud2(), ScanRejection::empty, "0 x 0");
  expectRejected(PointCloudBuilder().xyz().build({}), ScanRejection::empty, "0 x 1");
}

TEST(Rejections, missingCoordinate) {
  const auto flat = PointCloudBuilder().field("x", Field::FLOAT32).field("y", Field::FLOAT32);
  expectRejected(PointCloudBuilder(flat).build(sweep(0, 1)), ScanRejection::missing_xyz,
                 "fields: x y");
}

TEST(Rejections, unknownDatatype) {
  auto cloud = goodCloud();
  cloud.fields[1].datatype = 17;
  expectRejected(cloud, ScanRejection::missing_xyz, "field y");
}

TEST(Rejections, pointStepTooSmall) {
  auto cloud = goodCloud();
  cloud.point_step = 14;
  expectRejected(cloud, ScanRejection::bad_layout, "'t' ends at byte 16, point_step is 14");
  cloud.point_step = 0;
  expectRejected(cloud, ScanRejection::bad_layout, "point_step is 0");
}

TEST(Rejections, truncatedData) {
  auto cloud = goodCloud();
  cloud.data.pop_back();
  expectRejected(cloud, ScanRejection::bad_layout, "200 x 1 points");
  expectRejected(cloud, ScanRejection::bad_layout, "3199 bytes");
}

TEST(Rejections, nothingMeasured) {
  auto points = sweep(0, 99.8e6);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].x = i % 2 == 0 ? nan : 1.0 / 0.0;
  const auto cloud = PointCloudBuilder().xyz().field("t", Field::UINT32).build(points);
  expectRejected(cloud, ScanRejection::no_finite_points, "200 not finite, 0 at the origin");
}

TEST(Rejections, otherMessageTypes) {
  expectRejected(
      shapeShifter({1, 2, 3}, "sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369"),
      ScanRejection::unsupported_type, "'sensor_msgs/LaserScan'; supported:");
  expectRejected(topic_tools::ShapeShifter(), ScanRejection::unsupported_type, "supported:");
}

TEST(Rejections, pointCloud2OfAnyWrongLength) {
  const auto bytes = bytesOf(PointCloudBuilder().xyz().build(sweep(0, 1, 3)));
  const char* md5sum = ros::message_traits::md5sum<sensor_msgs::PointCloud2>();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::vector<std::uint8_t> start(bytes.begin(), bytes.begin() + static_cast<long>(length));
    expectRejected(shapeShifter(start, "sensor_msgs/PointCloud2", md5sum, ""),
                   ScanRejection::bad_layout, "message ends at byte " + std::to_string(length));
  }
  expectRejected(shapeShifter(bytes, "sensor_msgs/PointCloud2", "0123", ""),
                 ScanRejection::unsupported_type, "md5sum 0123");
}

TEST(Rejections, livoxOfAnyWrongLength) {
  const auto bytes = livoxBytes(1'700'000'000'000'000'000, 0, sweep(0, 99.8e6, 3));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const std::vector<std::uint8_t> start(bytes.begin(), bytes.begin() + static_cast<long>(length));
    expectRejected(shapeShifter(start, "livox_ros_driver/CustomMsg"), ScanRejection::bad_layout,
                   "message ends at byte " + std::to_string(length));
  }
  auto longer = bytes;
  longer.push_back(0);
  expectRejected(shapeShifter(longer, "livox_ros_driver/CustomMsg"), ScanRejection::bad_layout,
                 "1 bytes after the last field");
}

TEST(Rejections, pointCloud2ThatAnnouncesMoreThanItHas) {
  expectRejected(claiming<sensor_msgs::PointCloud2>(bytesThatAnnounceMore(goodCloud())),
                 ScanRejection::bad_layout, "4000000000 more wanted");
}

TEST(Rejections, livoxOfAnotherLayout) {
  const auto bytes = livoxBytes(1'700'000'000'000'000'000, 0, sweep(0, 99.8e6));
  expectRejected(
      shapeShifter(bytes, "livox_ros_driver/CustomMsg", "0123", "Header header\nuint8 a"),
      ScanRejection::unsupported_type, "md5sum 0123");
}

TEST(Rejections, livoxWithoutPoints) {
  expectRejected(shapeShifter(livoxBytes(5, 5, {}), "livox_ros_driver2/CustomMsg"),
                 ScanRejection::empty, "0 x 1");
}

}  // namespace
}  // namespace revisit_slam
