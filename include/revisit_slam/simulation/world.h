// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/simulation/mesh.h"
#include "revisit_slam/simulation/mover.h"
#include "revisit_slam/simulation/route.h"

namespace revisit_slam::simulation {

struct WorldConfig {
  /// At most this many moving cars over the whole drive; 0 makes the world static.
  int moving_cars = 200;
  /// At most this many people who walk near the platform over the whole drive.
  int people = 0;
};

/// All that a sensor can see. The kind and the seed of the world are those of the route.
struct World {
  /// What stands still, in the map frame.
  TriangleMesh still;
  /// Shapes of moving cars and people, in their own frames (see Mover::poseAt).
  std::vector<TriangleMesh> models;
  std::vector<Mover> cars;
  std::vector<Mover> people;
};

/// Lays the world around the route: the way itself stays free, and a place that the route visits
/// again is the same place.
World makeWorld(const WorldConfig& config, const Route& route);
/// The same world, laid around `first`, as a visit finds it: parked cars and traffic are others.
World makeWorld(const WorldConfig& config, const Route& first, const Route& visit);

}  // namespace revisit_slam::simulation
