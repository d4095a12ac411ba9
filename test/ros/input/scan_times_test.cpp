// SPDX-License-Identifier: MIT
// What a reader decides on the times of its first scans, and what changes that.
#include <gtest/gtest.h>

#include <limits>

#include "revisit_slam/ros/input/scan_reader.h"
#include "support/point_cloud_builder.h"
#include "support/raw_messages.h"

namespace revisit_slam {
namespace {

using Field = sensor_msgs::PointField;
constexpr std::int64_t start = 1'700'000'000'000'000'000;
constexpr std::int64_t period = 100'000'000;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ScanReading readTimes(ScanReader& reader, int scan, const std::vector<TestPoint>& points,
                      std::uint8_t type = Field::FLOAT32) {
  return reader.read(PointCloudBuilder(start + scan * period).xyz().field("t", type).build(points));
}

double afterHeader(const ScanReading& reading) {
  return secondsBetween(reading.header_stamp, reading.scan->stamp);
}

TEST(ScanTimes, constantTimesSwitchDeskewingOff) {
  ScanReader reader({});
  const ScanReading reading = readTimes(reader, 0, sweep(0.05, 0.05));
  ASSERT_TRUE(reading.scan);
  EXPECT_TRUE(reading.scan->times.empty());
  EXPECT_EQ(afterHeader(reading), 0.0);
  EXPECT_EQ(reader.description(), "deskewing off: field 't' is constant");
}

TEST(ScanTimes, implausibleTimesSwitchDeskewingOff) {
  ScanReader reader({});
  EXPECT_TRUE(readTimes(reader, 0, sweep(-3e5, 7e11)).scan->times.empty());
  EXPECT_EQ(reader.description(),
            "deskewing off: field 't', float32, from -300000 to 7e+11 is a sweep in no unit");
}

TEST(ScanTimes, anotherFieldServesWhereTheLikeliestIsConstant) {
  ScanReader reader({});
  PointCloudBuilder builder(start);
  auto cloud = builder.xyz()
                   .field("time", Field::FLOAT32)
                   .field("t", Field::FLOAT32)
                   .build(sweep(0, 0.0998));
  for (std::size_t i = 0; i < cloud.width; ++i) std::fill_n(&cloud.data[i * 20 + 16], 4, 0);
  EXPECT_EQ(reader.read(cloud).scan->times.size(), 200u);
  EXPECT_NE(reader.description().find("field 'time'"), std::string::npos);
}

TEST(ScanTimes, scansWithoutMeasurementsDoNotDecide) {
  ScanReader reader({});
  auto points = sweep(0, 99.8);
  for (auto& p : points) p.x = nan;
  EXPECT_FALSE(readTimes(reader, 0, points).scan);
  EXPECT_EQ(reader.description(), "");
  EXPECT_NEAR(afterHeader(readTimes(reader, 1, sweep(0, 0.0998))), 0.0998, 1e-6);
}

TEST(ScanTimes, aFewPointsDoNotChangeTheDecision) {
  ScanReader reader({});
  readTimes(reader, 0, sweep(0, 99.8));
  const std::string decided = reader.description();
  const ScanReading few = readTimes(reader, 1, sweep(50.0, 50.2, 3));
  EXPECT_NEAR(afterHeader(few), 0.0502, 1e-6);
  EXPECT_NEAR(few.scan->times.front(), -0.0002, 1e-6);
  EXPECT_EQ(reader.description(), decided);
}

TEST(ScanTimes, garbageTimesCostTheirPointsOnly) {
  struct Case {
    double first, last, garbage;
    std::uint8_t type;
  };
  const double now = static_cast<double>(start) * 1e-9;
  for (const Case& c :
       {Case{0, 0.0998, 0.9, Field::FLOAT32}, Case{0, 0.0998, -7e11, Field::FLOAT32},
        Case{0, 9.98e7, 4294967295.0, Field::UINT32},
        Case{now, now + 0.0998, 0.0, Field::FLOAT64}}) {
    ScanReader reader({});
    for (int scan = 0; scan < 4; ++scan) {  // from the first on, where nothing is known yet
      const double to_scan = c.first > 0 ? 0.1 * scan : 0.0;
      auto points = sweep(c.first + to_scan, c.last + to_scan);
      points[5].time = points[70].time = c.garbage;
      const ScanReading reading = readTimes(reader, scan, points, c.type);
      EXPECT_EQ(reading.scan->times.size(), 198u);
      EXPECT_EQ(reading.scan->points.size(), 198u);
      EXPECT_EQ(reading.counts.no_time, 2u);
      EXPECT_EQ(reading.counts.kept, 198u);
      EXPECT_NEAR(afterHeader(reading), 0.0998, 1e-6);
      EXPECT_NEAR(reading.scan->times.front(), -0.0998, 1e-6);
    }
  }
}

TEST(ScanTimes, slowSweepsKeepAllTimes) {
  ScanReader reader({});
  EXPECT_EQ(readTimes(reader, 0, sweep(0, 0.5)).scan->times.size(), 200u);
}

TEST(ScanTimes, contradictingTimesAreDecidedAnewAndReported) {
  ScanReader reader({});
  readTimes(reader, 0, sweep(0, 0.9));
  EXPECT_NE(reader.description().find("relative s"), std::string::npos);
  EXPECT_NEAR(afterHeader(readTimes(reader, 1, sweep(0, 99.8))), 0.0998, 1e-6);
  EXPECT_NE(reader.description().find("relative ms"), std::string::npos);
}

TEST(ScanTimes, stampsGoOnIncreasingWhereTimesFail) {
  ScanReader reader({});
  std::vector<std::int64_t> stamps;
  for (int scan = 0; scan < 4; ++scan) {
    const auto reading = readTimes(reader, scan, scan == 2 ? sweep(0, 0) : sweep(0, 0.0998));
    EXPECT_EQ(reading.scan->times.empty(), scan == 2);
    EXPECT_EQ(reader.deskewing(), scan != 2);
    stamps.push_back(reading.scan->stamp.nanoseconds);
  }
  for (std::size_t i = 1; i < stamps.size(); ++i) EXPECT_EQ(stamps[i] - stamps[i - 1], period);
}

TEST(ScanTimes, sensorsOnAnotherClockAreStampedByTheHeader) {
  ScanReader reader({});
  const ScanReading reading = readTimes(reader, 0, sweep(5000.0, 5000.0998), Field::FLOAT64);
  EXPECT_EQ(afterHeader(reading), 0.0);
  EXPECT_NEAR(reading.scan->times.front(), -0.0998, 1e-6);
  EXPECT_EQ(reader.description(),
            "points: field 't', float64, own clock s, sweep 99.8 ms, header taken as last point");
}

TEST(ScanTimes, absoluteNanosecondsAreExactToTheirResolution) {
  ScanReader reader({});
  const double first = static_cast<double>(start);
  const ScanReading reading =
      readTimes(reader, 0, sweep(first, first + 99'840'000), Field::FLOAT64);
  EXPECT_EQ(reading.scan->stamp.nanoseconds, start + 99'840'000);
}

TEST(ScanTimes, parametersDecide) {
  ScanInputConfig config;
  config.header_stamp = "last";
  config.time_unit = "us";
  ScanReader reader(config);
  const ScanReading reading = readTimes(reader, 0, sweep(0, 900), Field::UINT32);
  EXPECT_EQ(afterHeader(reading), 0.0);
  EXPECT_NEAR(reading.scan->times.front(), -0.0009, 1e-9);
}

TEST(ScanTimes, parametersThatTheDataContradictAreNamed) {
  ScanInputConfig config;
  config.time_unit = "s";
  ScanReader reader(config);
  EXPECT_TRUE(readTimes(reader, 0, sweep(0, 99.8)).scan->times.empty());
  EXPECT_EQ(reader.description(),
            "deskewing off: field 't' contradicts time_unit: s: a sweep would last 99.8 s "
            "(0 to 99.8)");
}

TEST(ScanTimes, aFieldThatNoMessageHasIsNotQuietlyDoneWithout) {
  ScanInputConfig config;
  config.time_field = "laser_time";
  ScanReader reader(config);
  const ScanReading reading = readTimes(reader, 0, sweep(0, 0.1));
  EXPECT_EQ(reading.rejection, ScanRejection::no_time_field);
  EXPECT_EQ(
      reading.detail,
      "deskewing off: no field 'laser_time' (fields: x y z t); set input/time_field to one of "
      "these fields, or to auto");
  config.time_field = "t";
  ScanReader other(config);
  EXPECT_TRUE(readTimes(other, 0, sweep(0, 0.1)).scan);
  const auto without = PointCloudBuilder(start + period).xyz().build(sweep(0, 0.1));
  EXPECT_TRUE(other.read(without).scan);  // messages have it, this one has lost it
}

TEST(ScanTimes, aRemedyIsSaidUnlessTimesAreKnownOrSwitchedOff) {
  ScanReader reader({});
  EXPECT_EQ(reader.remedy(), "");
  readTimes(reader, 0, sweep(0.05, 0.05));
  EXPECT_NE(reader.remedy().find("input/time_field to azimuth"), std::string::npos);
  readTimes(reader, 1, sweep(0, 0.0998));
  EXPECT_EQ(reader.remedy(), "");
  ScanInputConfig config;
  config.time_field = "none";
  ScanReader off(config);
  readTimes(off, 0, sweep(0, 0.0998));
  EXPECT_EQ(off.remedy(), "");
}

TEST(ScanTimes, aZeroHeaderStampIsRefusedUnlessTimesAreAbsoluteOrArrivalsAreUsed) {
  const auto relative = PointCloudBuilder(0).xyz().field("t", Field::FLOAT32).build(sweep(0, 0.1));
  const ScanReading refused = ScanReader({}).read(relative, {start});
  EXPECT_EQ(refused.rejection, ScanRejection::no_stamp);
  EXPECT_NE(refused.detail.find("input/stamps to arrival"), std::string::npos);

  const double seconds = 1e-9 * start;
  const auto absolute = PointCloudBuilder(0)
                            .xyz()
                            .field("timestamp", Field::FLOAT64)
                            .build(sweep(seconds, seconds + 0.1));
  const ScanReading absolute_reading = ScanReader({}).read(absolute);
  ASSERT_TRUE(absolute_reading.scan);
  EXPECT_NEAR(secondsBetween({start}, absolute_reading.scan->stamp), 0.1, 1e-6);

  ScanInputConfig config;
  config.stamps = "arrival";
  const ScanReading arrived = ScanReader(config).read(relative, {start});
  ASSERT_TRUE(arrived.scan);
  EXPECT_EQ(arrived.scan->stamp.nanoseconds, start);  // it came after its last point
  EXPECT_EQ(arrived.scan->times.size(), 200u);
}

TEST(ScanTimes, noneSwitchesOffAndWordsAreChecked) {
  ScanInputConfig config;
  config.time_field = "none";
  ScanReader reader(config);
  EXPECT_TRUE(readTimes(reader, 0, sweep(0, 0.0998)).scan->times.empty());
  EXPECT_EQ(reader.description(), "deskewing off: parameter time_field is none");
  config.header_stamp = "end";
  EXPECT_THROW(ScanReader{config}, ParameterError);
}

TEST(ScanTimes, azimuthTakesThePeriodFromTheHeaders) {
  ScanInputConfig config;
  config.time_field = "azimuth";
  ScanReader reader(config);
  const std::vector<TestPoint> points{{-10, 0.001, 0, 0}, {-10, -0.001, 0, 0}};
  for (const auto& [scan, expected] : {std::pair{0, 0.1}, {2, 0.2}, {3, 0.1}, {4, 0.1}}) {
    EXPECT_NEAR(readTimes(reader, scan, points).scan->times.front(), -expected, 1e-4);
  }
}

TEST(ScanTimes, livoxWithoutSynchronisationIsStampedByTheHeader) {
  ScanReader reader({});
  const auto bytes = livoxBytes(start, 1234, sweep(0, 99.8e6));
  const ScanReading reading = reader.read(shapeShifter(bytes, "livox_ros_driver/CustomMsg"));
  EXPECT_NEAR(afterHeader(reading), 0.0998, 1e-9);
  EXPECT_NE(reader.description().find("header = first point"), std::string::npos);
}

TEST(ScanTimes, livoxTimebaseCountsWhereItDiffersALittle) {
  ScanReader reader({});
  const auto bytes = livoxBytes(start + period, start, sweep(0, 99.8e6));
  const ScanReading reading = reader.read(shapeShifter(bytes, "livox_ros_driver2/CustomMsg"));
  EXPECT_EQ(reading.scan->stamp.nanoseconds, start + 99'800'000);
}

TEST(ScanTimes, livoxTimebaseAtTheEndOfItsRangeOverflowsNothing) {
  constexpr std::int64_t end = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t timebase : {end, end - 50'000'000, std::int64_t{-1}, -end}) {
    const auto message =
        shapeShifter(livoxBytes(start, timebase, sweep(0, 99.8e6)), "livox_ros_driver2/CustomMsg");
    ScanReader reader({});
    EXPECT_NEAR(afterHeader(reader.read(message)), 0.0998, 1e-9);  // not the clock of the header
    ScanInputConfig absolute;
    absolute.time_origin = "absolute";
    const ScanReading reading = ScanReader(absolute).read(message);
    EXPECT_FALSE(reading.scan);
    EXPECT_EQ(reading.rejection, ScanRejection::bad_stamp);
  }
}

TEST(ScanTimes, livoxDefinitionStandsInForAnUnknownMd5sum) {
  ScanReader reader({});
  const auto bytes = livoxBytes(start, start, sweep(0, 99.8e6));
  EXPECT_TRUE(reader.read(shapeShifter(bytes, "livox_ros_driver2/CustomMsg", "0123")).scan);
}

TEST(ScanTimes, pointCloud2ThroughAShapeShifter) {
  const auto cloud = PointCloudBuilder(start).xyz().field("t", Field::UINT32).build(sweep(0, 9e7));
  const auto message = claiming<sensor_msgs::PointCloud2>(bytesOf(cloud));
  ScanReader reader({});
  reader.setExtrinsics({Eigen::Quaterniond::Identity(), Eigen::Vector3d(1, 2, 3)});
  const ScanReading reading = reader.read(message);
  ASSERT_TRUE(reading.scan) << reading.detail;
  EXPECT_EQ(reading.frame_id, "lidar");
  EXPECT_NEAR(afterHeader(reading), 0.09, 1e-9);
  EXPECT_EQ(reading.scan->T_base_sensor.translation, Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace revisit_slam
