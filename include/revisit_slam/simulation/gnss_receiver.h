// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/simulation/route.h"
#include "revisit_slam/types/geodetic_position.h"

namespace revisit_slam::simulation {

/// A receiver without corrections: its antenna is displaced by white noise, and now and then by
/// reflections for a while, of which its covariance knows nothing.
struct GnssReceiverConfig {
  std::uint64_t seed = 1;
  double rate = 2.0;     ///< Hz
  double noise = 1.5;    ///< m, standard deviation on each horizontal axis; twice as much upwards
  double outages = 0.0;  ///< share of the time without a position, in pieces of outage_time
  double outage_time = 15;  ///< s
  int jumps = 0;            ///< how often reflections displace it
  double jump = 30.0;       ///< m, horizontally
  double jump_time = 5.0;   ///< s
  Eigen::Vector3d p_base_antenna = Eigen::Vector3d::Zero();
  /// Origin of the simulated world; its x axis points east.
  GeodeticPosition datum{48.1, 11.6, 520.0};
};

struct GnssSample {
  Stamp stamp;
  bool has_position = true;
  GeodeticPosition position;
  double deviation = 0.0;  ///< m, as it says itself, horizontal; twice as much upwards
};

std::vector<GnssSample> simulateGnss(const Route& route, Stamp end,
                                     const GnssReceiverConfig& config);

}  // namespace revisit_slam::simulation
