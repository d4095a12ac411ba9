// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "revisit_slam/simulation/route_config.h"
#include "revisit_slam/types/pose.h"

namespace revisit_slam::simulation {

/// How the body moves against the place on the road that it is above: the springs of a vehicle, or
/// the gait of a person who carries the sensor. Smooth in time and fading out at rest.
/// @param time seconds since the start of the drive; @param speed m/s.
Pose bodyMotion(MotionKind kind, std::uint64_t seed, double time, double speed);

}  // namespace revisit_slam::simulation
