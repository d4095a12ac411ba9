// SPDX-License-Identifier: MIT
// The same sweep in every way to write it down reads as the same scan.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "revisit_slam/ros/input/scan_reader.h"
#include "support/point_cloud_builder.h"

namespace revisit_slam {
namespace {

using Field = sensor_msgs::PointField;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<TestPoint> wholeNumbers() {
  auto points = sweep(0, 99, 100);
  for (TestPoint& p : points) p = {std::round(p.x), std::round(p.y), 1.0, std::round(p.time)};
  return points;
}

void expectWholeNumbers(const sensor_msgs::PointCloud2& cloud) {
  const ScanReading reading = ScanReader({}).read(cloud);
  ASSERT_TRUE(reading.scan) << reading.detail;
  const auto expected = wholeNumbers();
  ASSERT_EQ(reading.scan->points.size(), expected.size());
  ASSERT_EQ(reading.scan->times.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const TestPoint& p = expected[i];
    EXPECT_EQ(reading.scan->points[i], Eigen::Vector3d(p.x, p.y, p.z).cast<float>());
    EXPECT_NEAR(reading.scan->times[i], (p.time - 99.0) * 1e-3, 1e-8);
  }
}

TEST(Layouts, everyTypeInBothByteOrders) {
  for (std::uint8_t type = Field::INT8; type <= Field::FLOAT64; ++type) {
    const bool is_signed = type % 2 == 1 || type == Field::FLOAT64;
    const std::uint8_t xyz = is_signed ? type : static_cast<std::uint8_t>(Field::FLOAT32);
    PointCloudBuilder builder;
    builder.field("time", type).xyz(xyz);
    expectWholeNumbers(PointCloudBuilder(builder).build(wholeNumbers()));
    expectWholeNumbers(PointCloudBuilder(builder).bigEndian().build(wholeNumbers()));
  }
}

TEST(Layouts, mixedTypesInAnyOrder) {
  PointCloudBuilder builder;
  builder.field("z", Field::INT16).field("time", Field::UINT16).field("ring", Field::UINT8);
  expectWholeNumbers(
      builder.field("y", Field::FLOAT64).field("x", Field::INT8).build(wholeNumbers()));
}

TEST(Layouts, unalignedFields) {
  PointCloudBuilder builder;
  builder.field("x", Field::FLOAT32, 1)
      .field("y", Field::FLOAT32, 7)
      .field("z", Field::FLOAT32, 13);
  expectWholeNumbers(builder.field("t", Field::FLOAT64, 18).build(wholeNumbers()));
}

TEST(Layouts, rowsWithPadding) {
  for (const std::uint32_t padding : {0u, 1u, 37u}) {
    PointCloudBuilder builder;
    builder.xyz().field("t", Field::UINT32).rows(5, padding);
    expectWholeNumbers(builder.build(wholeNumbers()));
  }
}

TEST(Layouts, oneRowWithoutRowStep) {
  auto cloud = PointCloudBuilder().xyz().field("t", Field::UINT32).build(wholeNumbers());
  cloud.row_step = 0;
  expectWholeNumbers(cloud);
}

TEST(Layouts, dropoutsGoWithTheirTimes) {
  auto points = wholeNumbers();
  points[0].x = nan;
  points[10].y = 1.0 / 0.0;
  points[20] = {0, 0, 0, 20};
  points[30] = {0, 0, -0.0, 0};
  points[99].z = nan;
  for (auto& p : points) p.time *= 1e6;
  points[0].time = 3e9;  // dropped points often have no time either
  for (const bool is_dense : {false, true}) {
    auto cloud = PointCloudBuilder().xyz().field("t", Field::UINT32).build(points);
    cloud.is_dense = is_dense;  // drivers get it wrong
    const ScanReading reading = ScanReader({}).read(cloud);
    ASSERT_TRUE(reading.scan);
    EXPECT_EQ(reading.counts.received, 100u);
    EXPECT_EQ(reading.counts.not_finite, 3u);
    EXPECT_EQ(reading.counts.at_origin, 2u);
    EXPECT_EQ(reading.counts.kept, 95u);
    ASSERT_EQ(reading.scan->times.size(), 95u);
    EXPECT_NEAR(reading.scan->times[0], -0.097, 1e-8);
    EXPECT_NEAR(secondsBetween(reading.header_stamp, reading.scan->stamp), 0.098, 1e-9);
  }
}

TEST(Layouts, pointsWithoutTimeAreDropped) {
  auto points = sweep(0, 0.0998);
  points[5].time = nan;
  points[199].time = -1.0 / 0.0;
  const auto cloud = PointCloudBuilder().xyz().field("time", Field::FLOAT32).build(points);
  const ScanReading reading = ScanReader({}).read(cloud);
  ASSERT_TRUE(reading.scan);
  EXPECT_EQ(reading.counts.no_time, 2u);
  EXPECT_EQ(reading.counts.kept, 198u);
  EXPECT_EQ(reading.scan->points.size(), 198u);
  EXPECT_EQ(reading.scan->times.back(), 0.f);
  for (const float time : reading.scan->times) EXPECT_LE(time, 0.f);
}

}  // namespace
}  // namespace revisit_slam
