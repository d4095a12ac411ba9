// SPDX-License-Identifier: MIT
#include "revisit_slam/simulation/sensor_model.h"

#include <algorithm>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kDegree = 3.141592653589793 / 180.0;
constexpr int kRosetteLines = 6;
constexpr int kRosetteColumns = 4000;
constexpr int kNarrowLines = 80;
constexpr int kNarrowColumns = 600;

std::vector<double> evenly(double low, double high, int count) {
  std::vector<double> angles;
  for (int k = 0; k < count; ++k) {
    angles.push_back(kDegree * (low + (high - low) * k / (count - 1)));
  }
  return angles;
}

/// Two blocks of lasers, the upper one denser, as in car-top sensors.
std::vector<double> twoBlocks() {
  std::vector<double> angles = evenly(-24.8, -8.83, 32);
  const std::vector<double> upper = evenly(-8.33, 2.0, 32);
  angles.insert(angles.end(), upper.begin(), upper.end());
  return angles;
}

SensorModel spinning(const std::string& name, std::vector<double> elevations, int columns) {
  return {name, SensorKind::kSpinning, std::move(elevations), columns > 0 ? columns : 1024};
}

}  // namespace

const std::vector<std::string>& sensorNames() {
  static const std::vector<std::string> names{"spinning-16", "spinning-64", "spinning-128",
                                              "rosette", "narrow"};
  return names;
}

SensorModel makeSensor(const std::string& name, int columns) {
  if (columns < 0 || columns > 8192) {
    throw ParameterError("columns = " + std::to_string(columns) + ": must be within 0 and 8192");
  }
  if (name == "spinning-16") return spinning(name, evenly(-15.0, 15.0, 16), columns);
  if (name == "spinning-64") return spinning(name, twoBlocks(), columns);
  if (name == "spinning-128") return spinning(name, evenly(-22.5, 22.5, 128), columns);
  if (name == "rosette") {
    return {name, SensorKind::kRosette, std::vector<double>(kRosetteLines, 0.0),
            columns > 0 ? columns : kRosetteColumns};
  }
  if (name == "narrow") {
    return {name, SensorKind::kNarrow, evenly(-10.0, 10.0, kNarrowLines),
            columns > 0 ? columns : kNarrowColumns};
  }
  throw ParameterError("sensor = '" + name +
                       "': must be spinning-16, spinning-64, spinning-128, rosette or narrow");
}

}  // namespace revisit_slam::simulation
