// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "revisit_slam/geometry/voxel_filter.h"
#include "revisit_slam/types/submap.h"
#include "support/random_numbers.h"

namespace revisit_slam {

/// Houses and trees of random sizes on flat ground, 240 m x 240 m around the origin.
class Town {
 public:
  explicit Town(unsigned seed) : random_(seed) {
    for (double x = -108; x < 120; x += 24)
      for (double y = -108; y < 120; y += 24) addHouse(x + random_.uniform(-5, 5), y);
    for (int i = 0; i < 500; ++i) addTree(random_.inCube(120), random_.uniform(0.5, 2.5));
  }

  /// A local map around `T_town_local`, a point for each voxel of 0.5 m, with noise.
  LocalMap mapAt(unsigned id, const Pose& T_town_local, double radius = 90.0) {
    Points points_local;
    for (const Eigen::Vector3d& p_town : surface_) {
      const Eigen::Vector3d noisy = p_town + random_.inCube(0.05);
      const Eigen::Vector3d p = T_town_local.inverse() * noisy;
      if (p.norm() < radius) points_local.push_back(p.cast<float>());
    }
    LocalMap map;
    map.id = {id};
    VoxelFilter().filter(points_local, 0.5, map.points);
    return map;
  }

 private:
  void addHouse(double x, double y) {
    const double length = random_.uniform(6, 16), width = random_.uniform(5, 10);
    const double height = random_.uniform(3, 14);
    const Pose T{expSO3({0, 0, random_.uniform(0, 3)}), {x, y, 0}};
    for (double u = -0.5 * length; u < 0.5 * length; u += 0.25)
      for (const double side : {-0.5 * width, 0.5 * width})
        addColumn(T * Eigen::Vector3d(u, side, 0), height);
    for (double v = -0.5 * width; v < 0.5 * width; v += 0.25)
      for (const double side : {-0.5 * length, 0.5 * length})
        addColumn(T * Eigen::Vector3d(side, v, 0), height);
    for (double u = -12; u < 12; u += 0.5)
      for (double v = -12; v < 12; v += 0.5) surface_.emplace_back(x + u, y + v, 0.0);
  }

  void addTree(const Eigen::Vector3d& at, double radius) {
    const double height = random_.uniform(2, 12);
    for (double u = -radius; u < radius; u += 0.25)
      for (double v = -radius; v < radius; v += 0.25)
        addColumn({at.x() + u, at.y() + v, 0}, height * (1 - std::hypot(u, v) / radius));
  }

  void addColumn(const Eigen::Vector3d& foot, double height) {
    for (double z = 0.0; z < height; z += 0.25) surface_.emplace_back(foot.x(), foot.y(), z);
  }

  RandomNumbers random_;
  std::vector<Eigen::Vector3d> surface_;
};

/// On the ground of the town, with a little roll and pitch.
inline Pose poseInTown(double x, double y, double yaw) {
  return {expSO3({0, 0, yaw}) * expSO3({0.03, -0.04, 0}), {x, y, 1.5}};
}

}  // namespace revisit_slam
