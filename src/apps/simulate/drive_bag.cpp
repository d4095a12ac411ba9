// SPDX-License-Identifier: MIT
#include "drive_bag.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "cloud_writer.h"
#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/util/progress.h"
#include "sensor_messages.h"

namespace revisit_slam::simulation {
namespace {

/// Writes the readings of one sensor in the order of time, between the scans.
template <typename Reading>
class ReadingWriter {
 public:
  ReadingWriter(rosbag::Bag& bag, const char* topic, std::vector<Reading> readings)
      : bag_(bag), topic_(topic), readings_(std::move(readings)) {}

  void writeUntil(Stamp end) {
    for (; next_ < readings_.size() && readings_[next_].stamp <= end; ++next_)
      bag_.write(topic_, toRosTime(readings_[next_].stamp), messageOf(readings_[next_]));
  }

 private:
  rosbag::Bag& bag_;
  const char* topic_;
  std::vector<Reading> readings_;
  std::size_t next_ = 0;
};

bool isLost(const Options& o, int sensor, double seconds) {
  return std::any_of(o.lost.begin(), o.lost.end(), [&](const LostPiece& piece) {
    return piece.sensor == sensor && piece.begin <= seconds && seconds < piece.end;
  });
}

/// Writes the scans of the sensors beside the first one.
class FurtherSensorsWriter {
 public:
  FurtherSensorsWriter(rosbag::Bag& bag, const Options& o, const World& world, const Route& route)
      : bag_(bag), o_(o), start_(route.start()) {
    for (const FurtherSensor& sensor : o.further) {
      ScanConfig config = o.scan;
      config.seed += 7777 * static_cast<std::uint64_t>(sensor.number);
      config.T_base_sensor = sensor.T_base_sensor;
      simulators_.push_back(std::make_unique<ScanSimulator>(
          world, route, makeSensor(sensor.kind, o.columns), config));
    }
  }

  /// Those that begin after the first sensor's scan of this number and before its next.
  void write(int index, Stamp first) {
    constexpr double phase = 0.031;  // s, between one sensor and the next
    for (std::size_t i = 0; i < simulators_.size(); ++i) {
      const int number = o_.further[i].number;
      const Stamp begin = first.plusSeconds(std::fmod(phase * static_cast<double>(i + 1), 0.1));
      if (isLost(o_, number, secondsBetween(start_, begin))) continue;
      CloudWriter writer(simulators_[i]->sensor(), !o_.no_times, o_.with_labels);
      const SimulatedScan scan = simulators_[i]->simulate(begin);
      const auto cloud =
          writer.write(scan, static_cast<std::uint32_t>(index), "lidar_" + std::to_string(number));
      bag_.write("/points_" + std::to_string(number), toRosTime(scan.scan.stamp), cloud);
    }
  }

 private:
  rosbag::Bag& bag_;
  const Options& o_;
  const Stamp start_;
  std::vector<std::unique_ptr<ScanSimulator>> simulators_;
};

/// Whoever waits for what follows the last point of the last scan gets it.
constexpr double kReadingsAfterEnd = 0.1;  // s

}  // namespace

Summary writeBag(const Options& o, const World& world, const Route& route,
                 const ScanSimulator& simulator, int count) {
  rosbag::Bag bag(o.out, rosbag::bagmode::Write);
  bag.setCompression(rosbag::compression::LZ4);
  writeMountings(bag, o, route.start());
  const Stamp end = scanStart(route, count).plusSeconds(kReadingsAfterEnd);
  ReadingWriter<WheelReading> wheels(
      bag, "/wheel_odometry",
      o.with_wheels ? simulateWheels(route, end, o.wheels) : std::vector<WheelReading>());
  ReadingWriter<ImuSample> imu(
      bag, "/imu", o.with_imu ? simulateImu(route, end, o.imu) : std::vector<ImuSample>());
  ReadingWriter<GnssSample> gnss(
      bag, "/fix", o.with_gnss ? simulateGnss(route, end, o.gnss) : std::vector<GnssSample>());
  CloudWriter writer(simulator.sensor(), !o.no_times, o.with_labels);
  FurtherSensorsWriter further(bag, o, world, route);
  Progress progress("simulating", "scans", static_cast<std::size_t>(count), o.quiet);
  Summary summary;
  const auto record = [&](int index, const SimulatedScan& scan) {
    const auto cloud = writer.write(scan, static_cast<std::uint32_t>(index));
    const Stamp last = scan.scan.stamp;  // before which the sensor cannot send it
    wheels.writeUntil(last);
    imu.writeUntil(last);
    gnss.writeUntil(last);
    if (!isLost(o, 1, secondsBetween(route.start(), scan.first)))
      bag.write("/points", toRosTime(last), cloud);
    further.write(index, scan.first);
    summary.last_points.push_back(scan.scan.stamp);
    summary.points += cloud.width;
    progress.update(static_cast<std::size_t>(index) + 1);
  };
  simulateDrive(simulator, route, count, o.threads, record);
  wheels.writeUntil(end);
  imu.writeUntil(end);
  gnss.writeUntil(end);
  bag.close();
  progress.finish();
  return summary;
}

}  // namespace revisit_slam::simulation
