// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/input/point_fields.h"

#include <gtest/gtest.h>

#include <cstring>

#include "revisit_slam/ros/input/scan_reader.h"

namespace revisit_slam {
namespace {

/// Two rows of three points with padding, a field of three numbers and times in steps of 10 ms.
PointCloud someCloud() {
  PointCloud cloud;
  cloud.stamp = {1'700'000'000'000'000'007};
  cloud.frame_id = "lidar";
  cloud.width = 3;
  cloud.height = 2;
  cloud.point_step = 24;
  cloud.fields = {{"x", NumberType::float32, 0},
                  {"y", NumberType::float32, 4},
                  {"z", NumberType::float32, 8},
                  {"colour", NumberType::uint8, 13, 3},
                  {"t", NumberType::uint32, 20}};
  cloud.data.assign(cloud.points() * cloud.point_step, 0x41);
  for (std::size_t i = 0; i < cloud.points(); ++i) {
    const float xyz[] = {1.f + static_cast<float>(i), 2.f, 3.f};
    const auto ns = static_cast<std::uint32_t>(i * 10'000'000);
    std::memcpy(&cloud.data[i * cloud.point_step], xyz, sizeof(xyz));
    std::memcpy(&cloud.data[i * cloud.point_step + 20], &ns, sizeof(ns));
  }
  return cloud;
}

TEST(PointFields, AMessageHasAllThatTheCloudHas) {
  const PointCloud cloud = someCloud();
  const sensor_msgs::PointCloud2 message = toPointCloud2(cloud);
  EXPECT_EQ(message.header.frame_id, "lidar");
  EXPECT_EQ(message.header.stamp, ros::Time(1'700'000'000, 7));
  EXPECT_EQ(message.width, 3u);
  EXPECT_EQ(message.height, 2u);
  EXPECT_EQ(message.point_step, 24u);
  EXPECT_EQ(message.row_step, 72u);
  EXPECT_FALSE(message.is_bigendian);
  EXPECT_EQ(message.data, cloud.data);
  ASSERT_EQ(message.fields.size(), 5u);
  const sensor_msgs::PointField& colour = message.fields[3];
  EXPECT_EQ(colour.name, "colour");
  EXPECT_EQ(colour.datatype, sensor_msgs::PointField::UINT8);
  EXPECT_EQ(colour.offset, 13u);
  EXPECT_EQ(colour.count, 3u);
}

TEST(PointFields, ACloudIsReadAsItsMessage) {
  ScanReader of_cloud({}), of_message({});
  const ScanReading cloud = of_cloud.read(someCloud());
  const ScanReading message = of_message.read(toPointCloud2(someCloud()));
  ASSERT_TRUE(cloud.scan && message.scan) << cloud.detail << message.detail;
  EXPECT_EQ(cloud.scan->points, message.scan->points);
  EXPECT_EQ(cloud.scan->times, message.scan->times);
  EXPECT_EQ(cloud.scan->stamp, message.scan->stamp);
  EXPECT_EQ(cloud.scan->stamp.nanoseconds, 1'700'000'000'050'000'007);
  EXPECT_EQ(cloud.frame_id, message.frame_id);
  EXPECT_EQ(cloud.header_stamp, message.header_stamp);
}

TEST(PointFields, ADamagedCloudIsRejectedAsItsMessage) {
  PointCloud cloud = someCloud();
  cloud.data.resize(100);
  EXPECT_EQ(ScanReader({}).read(cloud).rejection, ScanRejection::bad_layout);
  EXPECT_EQ(ScanReader({}).read(PointCloud{}).rejection, ScanRejection::empty);
}

}  // namespace
}  // namespace revisit_slam
