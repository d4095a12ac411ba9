// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/local_voxel_map.h"
#include "support/synthetic_room.h"

namespace revisit_slam {

inline LocalVoxelMap mapOfRoom(double noise) {
  RandomNumbers random(1);
  LocalVoxelMap map({0.5, 20});
  map.insert(SyntheticRoom().sample({0, 0, 0}, 40000, noise, random), {});
  return map;
}

/// Points of the room as seen from `T_room_base`.
inline Points seenFrom(const Pose& T_room_base, const Points& points_room) {
  Points points;
  for (const auto& p : points_room)
    points.push_back((T_room_base.inverse() * p.cast<double>()).cast<float>());
  return points;
}

inline Points everyFifth(const Points& points) {
  Points some;
  for (std::size_t i = 0; i < points.size(); i += 5) some.push_back(points[i]);
  return some;
}

}  // namespace revisit_slam
