// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/priors/motion_reading.h"

namespace revisit_slam {

/// What wheels say of a body that starts at `start` and moves at a constant velocity.
inline OdometryReading odometryAt(Stamp start, double seconds, const Tangent& velocity) {
  OdometryReading reading;
  reading.stamp = start.plusSeconds(seconds);
  reading.T_world_base = exp(seconds * velocity);
  return reading;
}

inline ImuReading imuAt(Stamp start, double seconds, const Eigen::Vector3d& turn_rate) {
  ImuReading reading;
  reading.stamp = start.plusSeconds(seconds);
  reading.turn_rate = turn_rate;
  return reading;
}

}  // namespace revisit_slam
