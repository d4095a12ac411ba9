// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/uniform_spline.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam::simulation {

/// A car on the road, present from `from` to `until`.
struct MovingCar {
  /// Index into World::car_models.
  int model = 0;
  Stamp from;
  Stamp until;
  /// Position and forward direction over seconds since `from`, in the map frame.
  UniformSpline<6> motion;

  bool isPresent(Stamp stamp) const { return from <= stamp && stamp <= until; }
  /// T_map_car; the origin is on the ground below the middle of the car, x forward.
  Pose poseAt(Stamp stamp) const;
};

}  // namespace revisit_slam::simulation
