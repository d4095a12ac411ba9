// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/simulation/polyline.h"
#include "revisit_slam/simulation/uniform_spline.h"

namespace revisit_slam::simulation {

/// Arc length in metres over seconds since the start of the drive.
using SpeedProfile = UniformSpline<1>;

struct SpeedLimits {
  /// m/s
  double speed = 8.0;
  /// m/s^2
  double lateral_acceleration = 2.0;
  double acceleration = 1.2;
  /// Mean distance of stops, metres; 0: none.
  double stop_distance = 0.0;
  std::uint64_t seed = 1;
};

/// From rest to rest along the path, slower in curves. `path` is sampled every `step` metres.
SpeedProfile makeSpeedProfile(const Polyline& path, double step, const SpeedLimits& limits);

/// From arc lengths at instants that need not be evenly spaced.
SpeedProfile profileThrough(const std::vector<double>& times, const std::vector<double>& arcs);

}  // namespace revisit_slam::simulation
