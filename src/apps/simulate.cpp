// SPDX-License-Identifier: MIT
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/make_shared.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>

#include "revisit_slam/ros/messages/pose_conversions.h"
#include "revisit_slam/simulation/drive.h"
#include "revisit_slam/simulation/gnss_receiver.h"
#include "revisit_slam/simulation/motion_sensors.h"
#include "revisit_slam/simulation/report.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

/// A sensor beside the first one.
struct FurtherSensor {
  std::string kind;
  Pose T_base_sensor;
  int number;  ///< of its topic and frame, from 2
};

/// A piece of the drive in which a sensor is lost, s since its start.
struct LostPiece {
  int sensor;
  double begin, end;
};

struct Options {
  std::string out;
  std::string world = "town";
  std::string motion = "vehicle";
  std::string sensor = "spinning-64";
  RouteConfig route;
  WorldConfig traffic;
  ScanConfig scan;
  WheelConfig wheels;
  ImuConfig imu;
  GnssReceiverConfig gnss;
  bool with_wheels = false;
  bool with_imu = false;
  bool with_gnss = false;
  std::vector<std::string> also, lose;
  std::vector<FurtherSensor> further;
  std::vector<LostPiece> lost;
  double height = 0.0;
  double start_time = 1700000000.0;
  int columns = 0;
  int max_scans = 0;
  int threads = 0;
  bool no_times = false;
  bool still = false;
  bool quiet = false;
};

void declareDrive(CLI::App& app, Options& o) {
  app.add_option("--world", o.world, "kind of world")
      ->check(CLI::IsMember(worldNames()))
      ->capture_default_str();
  app.add_option("--route", o.route.route,
                 "tour, loop, opposite, lateral, crossing, out-and-back, figure-eight, or a TUM or "
                 "KITTI file")
      ->capture_default_str();
  app.add_option("--length", o.route.length, "metres; 0: 1000, or all of a file")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--speed", o.route.speed,
                 "highest speed in m/s; 0: as in the file, or usual in the world")
      ->check(CLI::Range(0.0, 40.0));
  app.add_option("--lateral-offset", o.route.lateral_offset,
                 "metres between the laps of --route lateral")
      ->check(CLI::Range(2.0, 8.0))
      ->capture_default_str();
  app.add_flag("--stop-and-go", o.route.stop_and_go, "stop about every 120 m");
  app.add_option("--motion", o.motion, "how the sensor is carried")
      ->check(CLI::IsMember({"vehicle", "handheld"}))
      ->capture_default_str();
  app.add_option("--seed", o.route.seed, "of world, route and noise")->capture_default_str();
  app.add_option("--max-cars", o.traffic.moving_cars, "moving cars over the whole drive")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--static", o.still, "no moving cars");
  app.add_option("--visit", o.route.visit.number,
                 "drive through the same world once more: each number from 1 has other traffic, "
                 "parked cars and noise")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--reverse", o.route.visit.reversed, "of a visit: from the way's end to its start");
  app.add_option("--aside", o.route.visit.aside, "of a visit: metres left of the lane")
      ->check(CLI::Range(-1.0, 4.0));
  app.add_option("--start-time", o.start_time, "seconds since 1970 at the start")
      ->check(CLI::Range(1.0, 4.0e9))
      ->capture_default_str();
}

void declareSensor(CLI::App& app, Options& o) {
  app.add_option("--sensor", o.sensor, "kind of sensor")
      ->check(CLI::IsMember(sensorNames()))
      ->capture_default_str();
  app.add_option("--columns", o.columns, "firings of a ring in a scan; 0: the sensor's own")
      ->check(CLI::Range(0, 8192));
  app.add_option("--dropout", o.scan.random_dropout, "share of measurements lost by chance")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--height", o.height, "sensor above base_link in metres; 0: 1.8, handheld 1.5")
      ->check(CLI::Range(0.0, 10.0));
  app.add_option("--noise", o.scan.noise, "standard deviation of the range in metres")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_flag("--no-times", o.no_times, "leave the field of point times out");
  app.add_flag("--deskewed", o.scan.deskewed, "cast all rays of a scan from the pose at its end");
}

void declareFurtherSensors(CLI::App& app, Options& o) {
  app.add_option(
         "--also", o.also,
         "one more sensor, \"KIND x y z yaw\" on base_link (m, deg), on /points_2, /points_3 and "
         "so on, out of phase with the others; may be repeated")
      ->take_all();
  app.add_option(
         "--lose", o.lose,
         "\"SENSOR FROM TO\": no messages of the sensor with this number, from 1, between these "
         "times (s); may be repeated")
      ->take_all();
}

void declareMotionSensors(CLI::App& app, Options& o) {
  app.add_flag("--wheels", o.with_wheels, "write /wheel_odometry, nav_msgs/Odometry");
  app.add_option("--wheel-scale-error", o.wheels.scale_error,
                 "share by which wheels count distances wrong, up or down by the seed")
      ->check(CLI::Range(0.0, 0.5))
      ->capture_default_str();
  app.add_option("--wheel-heading-noise", o.wheels.heading_noise,
                 "degrees, standard deviation of their heading after a metre")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_flag("--imu", o.with_imu, "write /imu, sensor_msgs/Imu, of a usual MEMS unit");
  app.add_option("--gyro-noise", o.imu.gyro_noise, "deg/s/sqrt(Hz)")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--gyro-bias", o.imu.gyro_bias, "deg/s, standard deviation on each axis")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
}

void declareGnss(CLI::App& app, Options& o) {
  app.add_flag(
      "--gnss", o.with_gnss,
      "write /fix, sensor_msgs/NavSatFix; the world's origin is at latitude 48.1, longitude "
      "11.6, altitude 520 m, and its x axis points east");
  app.add_option("--gnss-rate", o.gnss.rate, "Hz")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  app.add_option("--gnss-noise", o.gnss.noise,
                 "metres, standard deviation on each horizontal axis; twice as much upwards")
      ->check(CLI::Range(0.001, 100.0))
      ->capture_default_str();
  app.add_option("--gnss-outages", o.gnss.outages, "share of the time without positions")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--gnss-jumps", o.gnss.jumps, "how often positions are displaced for 5 s")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--gnss-jump", o.gnss.jump, "metres by which they are displaced")
      ->check(CLI::Range(0.0, 10000.0))
      ->capture_default_str();
}

void declareRun(CLI::App& app, Options& o) {
  app.add_option("--out", o.out, "bag to write; FILE.gt.tum and FILE.json are put beside it")
      ->required();
  app.add_option("--max-scans", o.max_scans, "0: all")->check(CLI::NonNegativeNumber);
  app.add_option("--threads", o.threads, "0: all; the result is the same")
      ->check(CLI::Range(0, 256));
  app.add_flag("--quiet", o.quiet, "no progress");
}

void completeSensors(Options& o) {
  for (const std::string& text : o.also) {
    std::istringstream words(text);
    FurtherSensor sensor{"", {}, static_cast<int>(o.further.size()) + 2};
    Eigen::Vector3d& t = sensor.T_base_sensor.translation;
    double yaw = 0.0;
    if (!(words >> sensor.kind >> t.x() >> t.y() >> t.z() >> yaw))
      throw ParameterError("--also is '" + text + "', not \"KIND x y z yaw\"");
    sensor.T_base_sensor.rotation = expSO3({0.0, 0.0, yaw * M_PI / 180.0});
    o.further.push_back(sensor);
  }
  for (const std::string& text : o.lose) {
    std::istringstream words(text);
    LostPiece piece{};
    if (!(words >> piece.sensor >> piece.begin >> piece.end))
      throw ParameterError("--lose is '" + text + "', not \"SENSOR FROM TO\"");
    o.lost.push_back(piece);
  }
}

void complete(Options& o) {
  completeSensors(o);
  o.route.world = worldKindOf(o.world);
  o.route.motion = o.motion == "handheld" ? MotionKind::kHandheld : MotionKind::kVehicle;
  o.route.start = Stamp::fromSeconds(o.start_time);
  o.scan.seed = o.route.seed + 1000 * static_cast<std::uint64_t>(o.route.visit.number);
  o.wheels.seed = o.imu.seed = o.gnss.seed = o.scan.seed;
  if (o.height <= 0.0) o.height = o.motion == "handheld" ? 1.5 : 1.8;
  o.scan.T_base_sensor.translation = {0.0, 0.0, o.height};
  // Turned by a right angle, so that whoever forgets the mounting notices.
  o.imu.T_base_imu = {expSO3({0.0, 0.0, 0.5 * M_PI}), {0.2, -0.1, 0.5 * o.height}};
  o.gnss.p_base_antenna = {-0.6, 0.3, o.height - 0.2};
  if (o.still) o.traffic.moving_cars = 0;
}

/// Writes the fields of one point after another into a message.
class CloudWriter {
 public:
  CloudWriter(const SensorModel& sensor, bool with_times)
      : kind_(sensor.kind), with_times_(with_times) {}

  sensor_msgs::PointCloud2 write(const SimulatedScan& scan, std::uint32_t sequence,
                                 const std::string& frame = "lidar") {
    sensor_msgs::PointCloud2 cloud;
    cloud.header.seq = sequence;
    cloud.header.stamp.fromNSec(static_cast<std::uint64_t>(scan.first.nanoseconds));
    cloud.header.frame_id = frame;
    declareFields(cloud);
    cloud.height = 1;
    cloud.width = static_cast<std::uint32_t>(scan.scan.points.size());
    cloud.row_step = cloud.point_step * cloud.width;
    cloud.is_dense = true;
    cloud.data.resize(cloud.row_step);
    target_ = cloud.data.data();
    for (std::size_t i = 0; i < scan.scan.points.size(); ++i) putPoint(scan, i);
    return cloud;
  }

 private:
  using Field = sensor_msgs::PointField;

  static void add(sensor_msgs::PointCloud2& cloud, const char* name, std::uint8_t type,
                  std::uint32_t size) {
    Field field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = type;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += size;
  }

  void declareFields(sensor_msgs::PointCloud2& cloud) const {
    for (const char* name : {"x", "y", "z", "intensity"}) add(cloud, name, Field::FLOAT32, 4);
    if (kind_ == SensorKind::kSpinning) {
      if (with_times_) add(cloud, "t", Field::UINT32, 4);
      add(cloud, "ring", Field::UINT16, 2);
    } else if (kind_ == SensorKind::kRosette) {
      add(cloud, "tag", Field::UINT8, 1);
      add(cloud, "line", Field::UINT8, 1);
      if (with_times_) add(cloud, "timestamp", Field::FLOAT64, 8);
    } else if (with_times_) {
      add(cloud, "time", Field::FLOAT32, 4);
    }
  }

  template <typename T>
  void put(T value) {
    std::memcpy(target_, &value, sizeof(T));
    target_ += sizeof(T);
  }

  void putPoint(const SimulatedScan& scan, std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) put<float>(scan.scan.points[i][axis]);
    put<float>(scan.intensities[i]);
    const std::uint32_t ns = scan.nanoseconds[i];
    if (kind_ == SensorKind::kSpinning) {
      if (with_times_) put<std::uint32_t>(ns);
      put<std::uint16_t>(scan.rings[i]);
    } else if (kind_ == SensorKind::kRosette) {
      put<std::uint8_t>(0x10);
      put<std::uint8_t>(static_cast<std::uint8_t>(scan.rings[i]));
      if (with_times_) put<double>(static_cast<double>(scan.first.nanoseconds + ns));
    } else if (with_times_) {
      put<float>(static_cast<float>(1e-9 * ns));
    }
  }

  SensorKind kind_;
  bool with_times_;
  std::uint8_t* target_ = nullptr;
};

geometry_msgs::TransformStamped mounting(const std::string& frame, const Pose& T_base_sensor,
                                         Stamp start) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = toRosTime(start);
  transform.header.frame_id = "base_link";
  transform.child_frame_id = frame;
  transform.transform = toTransformMessage(T_base_sensor);
  return transform;
}

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

/// Covariances of all zeros: not known.
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
      CloudWriter writer(simulators_[i]->sensor(), !o_.no_times);
      const auto cloud =
          writer.write(simulators_[i]->simulate(begin), static_cast<std::uint32_t>(index),
                       "lidar_" + std::to_string(number));
      bag_.write("/points_" + std::to_string(number), cloud.header.stamp, cloud);
    }
  }

 private:
  rosbag::Bag& bag_;
  const Options& o_;
  const Stamp start_;
  std::vector<std::unique_ptr<ScanSimulator>> simulators_;
};

/// A bar with rate and time left on a terminal, a line every ten per cent elsewhere.
class Progress {
 public:
  Progress(int total, bool quiet)
      : total_(total), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

  void show(int done) {
    const int tenth = 10 * done / total_;
    const bool due = terminal_ ? done % 5 == 0 || done == total_ : tenth != last_tenth_;
    if (quiet_ || !due) return;
    last_tenth_ = tenth;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const double rate = done / std::max(elapsed.count(), 1e-6);
    const double left = (total_ - done) / rate;
    if (terminal_) {
      const std::string bar(static_cast<std::size_t>(30 * done / total_), '#');
      std::fprintf(stderr, "\r[%-30s] %d/%d scans, %.1f/s, %.0f s left   ", bar.c_str(), done,
                   total_, rate, left);
    } else {
      std::fprintf(stderr, "%d/%d scans, %.1f/s, %.0f s left\n", done, total_, rate, left);
    }
    if (terminal_ && done == total_) std::fprintf(stderr, "\n");
  }

 private:
  int total_;
  bool quiet_;
  bool terminal_;
  int last_tenth_ = -1;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

/// Every option that was given or has a default, but those that do not change the result.
std::vector<std::pair<std::string, std::string>> optionsOf(const Options& o) {
  const auto number = [](double value) {
    std::ostringstream text;
    text << std::setprecision(12) << value;
    return text.str();
  };
  const auto flag = [](bool value) { return std::string(value ? "true" : "false"); };
  return {{"world", quoted(o.world)},
          {"route", quoted(o.route.route)},
          {"length", number(o.route.length)},
          {"speed", number(o.route.speed)},
          {"lateral-offset", number(o.route.lateral_offset)},
          {"stop-and-go", flag(o.route.stop_and_go)},
          {"motion", quoted(o.motion)},
          {"sensor", quoted(o.sensor)},
          {"columns", number(o.columns)},
          {"height", number(o.height)},
          {"noise", number(o.scan.noise)},
          {"dropout", number(o.scan.random_dropout)},
          {"seed", std::to_string(o.route.seed)},
          {"visit", std::to_string(o.route.visit.number)},
          {"reverse", flag(o.route.visit.reversed)},
          {"aside", number(o.route.visit.aside)},
          {"max-scans", number(o.max_scans)},
          {"max-cars", number(o.traffic.moving_cars)},
          {"no-times", flag(o.no_times)},
          {"deskewed", flag(o.scan.deskewed)},
          {"start-time", number(o.start_time)},
          {"wheels", flag(o.with_wheels)},
          {"imu", flag(o.with_imu)},
          {"gnss", flag(o.with_gnss)},
          {"gnss-rate", number(o.gnss.rate)},
          {"gnss-noise", number(o.gnss.noise)},
          {"gnss-outages", number(o.gnss.outages)},
          {"gnss-jumps", std::to_string(o.gnss.jumps)},
          {"gnss-jump", number(o.gnss.jump)},
          {"also", quoted(joined(o.also))},
          {"lose", quoted(joined(o.lose))}};
}

std::string besides(const std::string& bag, const std::string& ending) {
  const bool named_bag = bag.size() > 4 && bag.compare(bag.size() - 4, 4, ".bag") == 0;
  return (named_bag ? bag.substr(0, bag.size() - 4) : bag) + ending;
}

std::vector<Revisit> revisitsUntil(const Route& route, Stamp end) {
  std::vector<Revisit> seen;
  for (Revisit revisit : findRevisits(route)) {
    if (revisit.later_from > end) continue;
    revisit.later_until = std::min(revisit.later_until, end);
    seen.push_back(revisit);
  }
  return seen;
}

struct Summary {
  std::vector<Stamp> last_points;
  std::uint64_t points = 0;
};

/// Whoever waits for what follows the last point of the last scan gets it.
constexpr double kReadingsAfterEnd = 0.1;  // s

/// Writes all scans; the bag is whole when this returns.
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
  CloudWriter writer(simulator.sensor(), !o.no_times);
  FurtherSensorsWriter further(bag, o, world, route);
  Progress progress(count, o.quiet);
  Summary summary;
  const auto record = [&](int index, const SimulatedScan& scan) {
    const auto cloud = writer.write(scan, static_cast<std::uint32_t>(index));
    wheels.writeUntil(scan.first);
    imu.writeUntil(scan.first);
    gnss.writeUntil(scan.first);
    if (!isLost(o, 1, secondsBetween(route.start(), scan.first)))
      bag.write("/points", cloud.header.stamp, cloud);
    further.write(index, scan.first);
    summary.last_points.push_back(scan.scan.stamp);
    summary.points += cloud.width;
    progress.show(index + 1);
  };
  simulateDrive(simulator, route, count, o.threads, record);
  wheels.writeUntil(end);
  imu.writeUntil(end);
  gnss.writeUntil(end);
  bag.close();
  return summary;
}

DriveReport reportOf(const Options& o, const Route& route, const World& world,
                     const Summary& summary) {
  DriveReport report;
  report.options = optionsOf(o);
  report.scans = static_cast<int>(summary.last_points.size());
  report.points = summary.points;
  report.start = route.start();
  report.end = summary.last_points.empty() ? route.start() : summary.last_points.back();
  report.length = route.arcAt(report.end);
  report.triangles = world.still.triangles.size();
  report.moving_cars = world.cars.size();
  report.revisits = revisitsUntil(route, report.end);
  return report;
}

void run(Options o) {
  complete(o);
  const Route route = makeRoute(o.route);
  const World world = makeWorld(o.traffic, worldRoute(o.route), route);
  const ScanSimulator simulator(world, route, makeSensor(o.sensor, o.columns), o.scan);
  const int count = scanCount(route, o.max_scans);
  if (!o.quiet) {
    std::fprintf(stderr, "%s: %.0f m, %.1f s, %d scans, %zu triangles, %zu moving cars\n",
                 o.world.c_str(), route.length(), secondsBetween(route.start(), route.end()), count,
                 world.still.triangles.size(), world.cars.size());
  }
  const Summary summary = writeBag(o, world, route, simulator, count);
  writeTruth(besides(o.out, ".gt.tum"), route, summary.last_points);
  writeReport(besides(o.out, ".json"), reportOf(o, route, world, summary));
}

}  // namespace
}  // namespace revisit_slam::simulation

int main(int argc, char** argv) {
  CLI::App app("Simulates a LiDAR drive and writes it as a ROS bag with its true trajectory.",
               "simulate");
  revisit_slam::simulation::Options options;
  revisit_slam::simulation::declareRun(app, options);
  revisit_slam::simulation::declareDrive(app, options);
  revisit_slam::simulation::declareSensor(app, options);
  revisit_slam::simulation::declareFurtherSensors(app, options);
  revisit_slam::simulation::declareMotionSensors(app, options);
  revisit_slam::simulation::declareGnss(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    revisit_slam::simulation::run(options);
  } catch (const std::exception& error) {
    std::cerr << "simulate: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
