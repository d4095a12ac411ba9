// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/uniform_spline.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam::simulation {

/// A car on the road or a person who walks, present from `from` to `until`.
struct Mover {
  /// Index into World::models.
  int model = 0;
  Stamp from;
  Stamp until;
  /// Position and forward direction over seconds since `from`, in the map frame.
  UniformSpline<6> motion;

  bool isPresent(Stamp stamp) const { return from <= stamp && stamp <= until; }
  /// T_map_mover; the origin is on the ground below its middle, x forward.
  Pose poseAt(Stamp stamp) const;
};

}  // namespace revisit_slam::simulation
