// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace revisit_slam::simulation {

enum class SensorKind { kSpinning, kRosette, kNarrow };

/// One measurement of the pattern.
struct Firing {
  /// Unit vector in the sensor's frame: x forward, y left, z up.
  Eigen::Vector3f direction;
  /// Since the start of the scan.
  std::int32_t nanoseconds = 0;
  /// Ring of a spinning sensor (0 is the lowest), else the laser line.
  std::uint16_t ring = 0;
};

/// What a sensor is, apart from the noise. Ten scans a second.
struct SensorModel {
  std::string name;
  SensorKind kind = SensorKind::kSpinning;
  /// Angles above the horizon for each ring, radians; empty for the rosette.
  std::vector<double> elevations;
  /// Firings of a ring in a scan.
  int columns = 1024;
  /// Metres.
  double min_range = 0.5;
  double max_range = 120.0;

  static constexpr std::int64_t kPeriodNanoseconds = 100000000;
};

/// spinning-16, spinning-64, spinning-128, rosette, narrow.
const std::vector<std::string>& sensorNames();

/// @param columns 0 for the sensor's own.
/// @throw ParameterError for a name that is none of sensorNames().
SensorModel makeSensor(const std::string& name, int columns = 0);

/// The firings of a scan in the order of time. Only the rosette differs from scan to scan.
std::vector<Firing> firingsOf(const SensorModel& sensor, std::uint64_t scan_index);

}  // namespace revisit_slam::simulation
