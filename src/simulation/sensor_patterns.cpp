// SPDX-License-Identifier: MIT
#include <cmath>

#include "revisit_slam/simulation/sensor_model.h"

namespace revisit_slam::simulation {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kPeriodSeconds = 0.1;
constexpr double kHalfNarrow = 60.0 * kTwoPi / 360.0;
/// Each prism of the rosette bends the beam by this angle; together they reach 35 degrees.
constexpr double kPrism = 17.4 * kTwoPi / 360.0;
constexpr double kFirstPrismHertz = 121.57;
constexpr double kSecondPrismHertz = -77.73;
constexpr double kLineSpread = 0.45 * kTwoPi / 360.0;

Eigen::Vector3f towards(double azimuth, double elevation) {
  return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
      .cast<float>();
}

std::int32_t instant(int index, int count) {
  return static_cast<std::int32_t>(SensorModel::kPeriodNanoseconds * index / count);
}

/// All rings at once, column by column, clockwise, beginning backwards.
std::vector<Firing> spinning(const SensorModel& sensor) {
  std::vector<Firing> firings;
  firings.reserve(sensor.elevations.size() * static_cast<std::size_t>(sensor.columns));
  for (int column = 0; column < sensor.columns; ++column) {
    const double azimuth = 0.5 * kTwoPi - kTwoPi * column / sensor.columns;
    std::uint16_t ring = 0;
    for (const double elevation : sensor.elevations) {
      firings.push_back({towards(azimuth, elevation), instant(column, sensor.columns), ring++});
    }
  }
  return firings;
}

/// The beam through two prisms that turn at rates without a common period, for several lasers that
/// lie side by side.
std::vector<Firing> rosette(const SensorModel& sensor, std::uint64_t scan_index) {
  const int lines = static_cast<int>(sensor.elevations.size());
  std::vector<Firing> firings;
  firings.reserve(static_cast<std::size_t>(lines * sensor.columns));
  for (int column = 0; column < sensor.columns; ++column) {
    const double time = kPeriodSeconds * (static_cast<double>(scan_index) +
                                          static_cast<double>(column) / sensor.columns);
    const double first = kTwoPi * std::fmod(kFirstPrismHertz * time, 1.0);
    const double second = kTwoPi * std::fmod(kSecondPrismHertz * time, 1.0);
    const double y = kPrism * (std::cos(first) + std::cos(second));
    const double z = kPrism * (std::sin(first) + std::sin(second));
    for (int line = 0; line < lines; ++line) {
      const double aside = kLineSpread * (line - 0.5 * (lines - 1)) / lines;
      const double azimuth = y - aside * std::sin(first), elevation = z + aside * std::cos(first);
      const double angle = std::hypot(azimuth, elevation);
      const double scale = angle > 0.0 ? std::sin(angle) / angle : 1.0;
      firings.push_back(
          {Eigen::Vector3d(std::cos(angle), scale * azimuth, scale * elevation).cast<float>(),
           instant(column, sensor.columns), static_cast<std::uint16_t>(line)});
    }
  }
  return firings;
}

/// Line by line from below, forth and back in turn.
std::vector<Firing> narrow(const SensorModel& sensor) {
  const int lines = static_cast<int>(sensor.elevations.size());
  std::vector<Firing> firings;
  firings.reserve(static_cast<std::size_t>(lines * sensor.columns));
  for (int line = 0; line < lines; ++line) {
    for (int k = 0; k < sensor.columns; ++k) {
      const double sweep = kHalfNarrow * (2.0 * k / (sensor.columns - 1) - 1.0);
      const double azimuth = line % 2 == 0 ? -sweep : sweep;
      firings.push_back({towards(azimuth, sensor.elevations[static_cast<std::size_t>(line)]),
                         instant(line * sensor.columns + k, lines * sensor.columns),
                         static_cast<std::uint16_t>(line)});
    }
  }
  return firings;
}

}  // namespace

std::vector<Firing> firingsOf(const SensorModel& sensor, std::uint64_t scan_index) {
  switch (sensor.kind) {
    case SensorKind::kSpinning:
      return spinning(sensor);
    case SensorKind::kRosette:
      return rosette(sensor, scan_index);
    case SensorKind::kNarrow:
      return narrow(sensor);
  }
  return {};
}

}  // namespace revisit_slam::simulation
