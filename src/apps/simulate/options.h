// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "revisit_slam/simulation/drive.h"
#include "revisit_slam/simulation/gnss_receiver.h"
#include "revisit_slam/simulation/motion_sensors.h"

namespace revisit_slam::simulation {

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
  bool with_labels = false;
  bool still = false;
  bool quiet = false;
};

void declareOptions(CLI::App& app, Options& o);

/// What follows from what was given. @throws ParameterError
void complete(Options& o);

/// Every option that was given or has a default, but those that do not change the result.
std::vector<std::pair<std::string, std::string>> namedOptions(const Options& o);

}  // namespace revisit_slam::simulation
