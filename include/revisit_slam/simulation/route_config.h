// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "revisit_slam/simulation/layout.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam::simulation {

enum class MotionKind { kVehicle, kHandheld };

/// How a drive through a world differs from the one that the world was laid around.
struct VisitConfig {
  /// 0: that drive itself; each other number has other traffic, parked cars and noise of its own.
  int number = 0;
  /// From the end of the way to its beginning, on the lane of that direction.
  bool reversed = false;
  /// Metres left of the lane.
  double aside = 0.0;
};

/// How the platform moves through the world.
struct RouteConfig {
  WorldKind world = WorldKind::kTown;
  std::uint64_t seed = 1;
  /// One of routeNames(), or the path of a TUM or KITTI trajectory file.
  std::string route = "tour";
  /// Metres; 0: as long as the file, or 1000 for a named route.
  double length = 0.0;
  /// Highest speed, m/s; 0: as in the file, or what suits the world.
  double speed = 0.0;
  bool stop_and_go = false;
  /// Distance of the later laps from the first on the route `lateral`, metres, 2 to 8.
  double lateral_offset = 5.0;
  MotionKind motion = MotionKind::kVehicle;
  VisitConfig visit;
  /// The instant at which the drive begins.
  Stamp start{1700000000000000000};
};

const std::vector<std::string>& routeNames();
bool isNamedRoute(const std::string& route);

}  // namespace revisit_slam::simulation
