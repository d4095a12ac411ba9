// SPDX-License-Identifier: MIT
#include "options.h"

#include <iomanip>
#include <sstream>

#include "revisit_slam/simulation/report.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

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
  app.add_option("--people", o.traffic.people,
                 "people who walk near the way over the whole drive, at most")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--static", o.still, "no moving cars, no people");
  app.add_option("--visit", o.route.visit.number,
                 "drive through the same world once more: each number from 1 has other traffic, "
                 "parked cars and noise")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--reverse", o.route.visit.reversed,
               "of a visit: drives the way from its end to its start");
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
  app.add_flag("--labels", o.with_labels,
               "a field \"moving\" of each point: 1 where it is of a moving car or of a person");
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

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

}  // namespace

void declareOptions(CLI::App& app, Options& o) {
  declareRun(app, o);
  declareDrive(app, o);
  declareSensor(app, o);
  declareFurtherSensors(app, o);
  declareMotionSensors(app, o);
  declareGnss(app, o);
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
  if (o.still) o.traffic.moving_cars = o.traffic.people = 0;
}

std::vector<std::pair<std::string, std::string>> namedOptions(const Options& o) {
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
          {"people", number(o.traffic.people)},
          {"labels", flag(o.with_labels)},
          {"no-times", flag(o.no_times)},
          {"deskewed", flag(o.scan.deskewed)},
          {"start-time", number(o.start_time)},
          {"wheels", flag(o.with_wheels)},
          {"wheel-scale-error", number(o.wheels.scale_error)},
          {"wheel-heading-noise", number(o.wheels.heading_noise)},
          {"imu", flag(o.with_imu)},
          {"gyro-noise", number(o.imu.gyro_noise)},
          {"gyro-bias", number(o.imu.gyro_bias)},
          {"gnss", flag(o.with_gnss)},
          {"gnss-rate", number(o.gnss.rate)},
          {"gnss-noise", number(o.gnss.noise)},
          {"gnss-outages", number(o.gnss.outages)},
          {"gnss-jumps", std::to_string(o.gnss.jumps)},
          {"gnss-jump", number(o.gnss.jump)},
          {"also", quoted(joined(o.also))},
          {"lose", quoted(joined(o.lose))}};
}

}  // namespace revisit_slam::simulation
