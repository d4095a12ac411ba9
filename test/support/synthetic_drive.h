// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "revisit_slam/odometry/odometry_config.h"
#include "support/synthetic_room.h"

namespace revisit_slam {

inline OdometryConfig roomConfig() {
  OdometryConfig config;
  config.max_range = 60.0;
  config.map.voxel_size = 0.5;
  return config;
}

struct Drive {
  std::vector<Scan> scans;
  std::vector<Pose> T_first_base;
  Tangent last_velocity;
};

/// Through the room with a velocity for each sweep, which `velocityOf(i)` gives.
template <typename VelocityOf>
Drive driveInRoomWith(const VelocityOf& velocityOf, int count, double noise = 0.01) {
  constexpr std::int64_t start = 1'700'000'000'000'000'000, period = 100'000'000;
  RandomNumbers random(1);
  const Pose T_base_sensor{expSO3({0.02, -0.05, 1.0}), {0.8, 0.1, 0.5}};
  const Pose T_room_first{expSO3({0, 0, 0.4}), {-8, -2, -1}};
  Drive drive;
  Pose T_room_base = T_room_first;
  for (int i = 0; i < count; ++i) {
    drive.last_velocity = velocityOf(i);
    T_room_base = boxplus(T_room_base, 1e-9 * period * drive.last_velocity);
    drive.scans.push_back(SyntheticRoom().sweep({start + i * period}, T_room_base,
                                                drive.last_velocity, T_base_sensor, noise, random));
    drive.T_first_base.push_back(T_room_first.inverse() * T_room_base);
  }
  return drive;
}

/// A curve that starts from rest.
inline Drive driveInRoom(int count, double noise = 0.01) {
  Tangent full_speed;
  full_speed << 4.0, 0.2, 0.0, 0.02, -0.03, 0.4;
  return driveInRoomWith([&](int i) -> Tangent { return full_speed * std::min(1.0, 0.1 * i); },
                         count, noise);
}

/// Somebody who walks ahead, and nods twice a second.
inline Drive walkInRoom(int count) {
  return driveInRoomWith(
      [](int i) {
        Tangent velocity = Tangent::Zero();
        velocity[0] = 1.3;
        velocity[4] = 0.4 * std::cos(2.0 * M_PI * 0.2 * i);
        return Tangent(std::min(1.0, 0.1 * i) * velocity);
      },
      count);
}

}  // namespace revisit_slam
