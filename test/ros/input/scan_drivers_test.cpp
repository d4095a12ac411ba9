// SPDX-License-Identifier: MIT
// A message as each driver sends it: what is recognised, and when its points were measured.
#include <gtest/gtest.h>

#include "revisit_slam/ros/input/scan_reader.h"
#include "support/point_cloud_builder.h"
#include "support/raw_messages.h"

namespace revisit_slam {
namespace {

using Field = sensor_msgs::PointField;
constexpr std::int64_t header = 1'700'000'000'100'000'000;
constexpr double header_s = 1'700'000'000.1;

/// The last point is at the end of a sweep of 99.8 ms, whose stamp is this long after the header.
void expectSweep(const ScanReading& reading, double last_after_header, double tolerance = 1e-6) {
  ASSERT_TRUE(reading.scan) << describe(reading.rejection) << ": " << reading.detail;
  const Scan& scan = *reading.scan;
  EXPECT_NEAR(secondsBetween({header}, scan.stamp), last_after_header, tolerance);
  ASSERT_EQ(scan.times.size(), scan.points.size());
  EXPECT_EQ(scan.times.back(), 0.f);
  EXPECT_NEAR(scan.times.front(), -0.0998, 1e-6);
  EXPECT_NEAR(scan.points.front().x(), 10.f, 1e-6);
}

TEST(Drivers, velodyne) {
  ScanReader reader({});
  const auto cloud = PointCloudBuilder(header)
                         .xyz()
                         .field("intensity", Field::FLOAT32)
                         .field("ring", Field::UINT16)
                         .field("time", Field::FLOAT32)
                         .build(sweep(-0.0998, 0.0));
  expectSweep(reader.read(cloud), 0.0);
  EXPECT_EQ(reader.description(),
            "points: field 'time', float32, relative s, sweep 99.8 ms, header = last point");
}

TEST(Drivers, velodyneWithTimesOnBothSidesOfTheHeader) {
  ScanReader reader({});
  const auto cloud =
      PointCloudBuilder(header).xyz().field("time", Field::FLOAT32).build(sweep(-0.0992, 0.0006));
  expectSweep(reader.read(cloud), 0.0006);
}

TEST(Drivers, ousterColumnsUnsortedAfterDestagger) {
  auto points = sweep(0, 99.8e6, 2048);
  std::swap(points[1], points[900]);
  for (std::size_t i = 100; i + 8 < 2000; i += 8) std::swap(points[i].time, points[i + 7].time);
  ScanReader reader({});
  const auto cloud = PointCloudBuilder(header)
                         .field("x", Field::FLOAT32, 0)
                         .field("y", Field::FLOAT32, 4)
                         .field("z", Field::FLOAT32, 8)
                         .field("intensity", Field::FLOAT32, 16)
                         .field("t", Field::UINT32, 20)
                         .field("reflectivity", Field::UINT16, 24)
                         .field("range", Field::UINT32, 32)
                         .rows(16)
                         .build(points);
  const ScanReading reading = reader.read(cloud);
  expectSweep(reading, 0.0998);
  EXPECT_NEAR(reading.scan->times[1], (points[1].time - 99.8e6) * 1e-9, 1e-7);
  EXPECT_EQ(reader.description(),
            "points: field 't', uint32, relative ns, sweep 99.8 ms, header = first point");
}

TEST(Drivers, hesai) {
  ScanReader reader({});
  const auto cloud = PointCloudBuilder(header)
                         .xyz()
                         .field("intensity", Field::FLOAT32)
                         .field("timestamp", Field::FLOAT64)
                         .field("ring", Field::UINT16)
                         .build(sweep(header_s, header_s + 0.0998));
  expectSweep(reader.read(cloud), 0.0998);
  EXPECT_EQ(reader.description(),
            "points: field 'timestamp', float64, absolute s, sweep 99.8 ms, header = first point");
}

TEST(Drivers, robosenseAtUnalignedOffsetWithEitherHeader) {
  for (const double first : {header_s, header_s - 0.0998}) {
    ScanReader reader({});
    const auto cloud = PointCloudBuilder(header)
                           .xyz()
                           .field("intensity", Field::FLOAT32, 12)
                           .field("ring", Field::UINT16, 16)
                           .field("timestamp", Field::FLOAT64, 18)
                           .build(sweep(first, first + 0.0998));
    expectSweep(reader.read(cloud), first + 0.0998 - header_s);
    EXPECT_EQ(
        reader.description(),
        std::string("points: field 'timestamp', float64, absolute s, sweep 99.8 ms, header ") +
            (first < header_s ? "= last point" : "= first point"));
  }
}

TEST(Drivers, livoxCustomMsgOfBothDrivers) {
  for (const char* package : {"livox_ros_driver", "livox_ros_driver2"}) {
    ScanReader reader({});
    const ScanReading reading = reader.read(shapeShifter(
        livoxBytes(header, header, sweep(0, 99.8e6)), std::string(package) + "/CustomMsg"));
    expectSweep(reading, 0.0998);
    EXPECT_EQ(reading.scan->stamp.nanoseconds, header + 99'800'000);
    EXPECT_EQ(reading.frame_id, "livox_frame");
    EXPECT_EQ(reading.header_stamp.nanoseconds, header);
    EXPECT_EQ(reader.description(),
              "points: field 'offset_time', uint32, relative ns, sweep 99.8 ms, "
              "timebase = first point");
  }
}

TEST(Drivers, livoxPointCloud2) {
  ScanReader reader({});
  const double first = static_cast<double>(header);
  const auto cloud = PointCloudBuilder(header)
                         .xyz()
                         .field("intensity", Field::FLOAT32)
                         .field("tag", Field::UINT8)
                         .field("line", Field::UINT8)
                         .field("timestamp", Field::FLOAT64)
                         .build(sweep(first, first + 99.8e6));
  expectSweep(reader.read(cloud), 0.0998);
  EXPECT_EQ(reader.description(),
            "points: field 'timestamp', float64, absolute ns, sweep 99.8 ms, header = first point");
}

TEST(Drivers, noTimeField) {
  ScanReader reader({});
  const auto cloud =
      PointCloudBuilder(header).xyz().field("intensity", Field::FLOAT32).build(sweep(0, 0));
  const ScanReading reading = reader.read(cloud);
  ASSERT_TRUE(reading.scan);
  EXPECT_TRUE(reading.scan->times.empty());
  EXPECT_EQ(reading.scan->stamp.nanoseconds, header);
  EXPECT_FALSE(reader.deskewing());
  EXPECT_EQ(reader.description(), "deskewing off: no time field (fields: x y z intensity)");
}

TEST(Drivers, kittiByAzimuth) {
  ScanInputConfig config;
  config.time_field = "azimuth";
  config.scan_period = 0.1;
  ScanReader reader(config);
  const auto cloud = PointCloudBuilder(header)
                         .xyz()
                         .field("intensity", Field::FLOAT32)
                         .build({{-10, 0.001, 0, 0}, {10, 0, 0, 0}, {0, -10, 0, 0}});
  const ScanReading reading = reader.read(cloud);
  ASSERT_TRUE(reading.scan);
  EXPECT_NEAR(secondsBetween({header}, reading.scan->stamp), -0.025, 1e-7);
  EXPECT_NEAR(reading.scan->times[0], -0.075, 1e-5);
  EXPECT_NEAR(reading.scan->times[1], -0.025, 1e-7);
  EXPECT_EQ(reading.scan->times[2], 0.f);
  EXPECT_EQ(reader.description(),
            "points: azimuth, clockwise from 180 deg, sweep 100 ms, header = last point");
}

}  // namespace
}  // namespace revisit_slam
