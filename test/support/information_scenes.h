// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "revisit_slam/icp/local_voxel_map.h"

namespace revisit_slam {

/// Points on rectangles in the base frame, with the map that the same surfaces leave.
class Scene {
 public:
  /// A rectangle through `centre` spanned by +-u and +-v, with points about every `spacing` metres.
  void addRectangle(const Eigen::Vector3f& centre, const Eigen::Vector3f& u,
                    const Eigen::Vector3f& v, float spacing) {
    std::uniform_real_distribution<float> jitter(-0.5f, 0.5f);
    const int rows = static_cast<int>(2.0f * u.norm() / spacing);
    const int columns = static_cast<int>(2.0f * v.norm() / spacing);
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const float a = (static_cast<float>(i) + 0.5f + jitter(random_)) / static_cast<float>(rows);
        const float b =
            (static_cast<float>(j) + 0.5f + jitter(random_)) / static_cast<float>(columns);
        points_base.push_back(centre + (2.0f * a - 1.0f) * u + (2.0f * b - 1.0f) * v);
      }
  }

  /// The map is dense, as after many scans, and its points are not those of the scan.
  LocalVoxelMap map(const Pose& T_odom_base) {
    LocalVoxelMapConfig config;
    config.max_points_per_voxel = 100;
    LocalVoxelMap map(config);
    map.insert(map_points_base, T_odom_base);
    return map;
  }

  void addSurface(const Eigen::Vector3f& centre, const Eigen::Vector3f& u,
                  const Eigen::Vector3f& v) {
    Scene dense;
    dense.random_.seed(random_());
    dense.addRectangle(centre, u, v, 0.1f);
    map_points_base.insert(map_points_base.end(), dense.points_base.begin(),
                           dense.points_base.end());
    addRectangle(centre, 0.9f * u, 0.9f * v, 0.8f);
  }

  Points points_base, map_points_base;

 private:
  std::mt19937 random_{7};
};

inline Scene makePlane() {
  Scene scene;
  scene.addSurface({0, 0, -1.8f}, {20, 0, 0}, {0, 20, 0});
  return scene;
}

/// Two walls along x and the ground: nothing holds x.
inline Scene makeCorridor() {
  Scene scene;
  scene.addSurface({0, 0, -1.8f}, {20, 0, 0}, {0, 3, 0});
  scene.addSurface({0, 3, 0}, {20, 0, 0}, {0, 0, 1.8f});
  scene.addSurface({0, -3, 0}, {20, 0, 0}, {0, 0, 1.8f});
  return scene;
}

/// Ground and two walls that meet: everything is held.
inline Scene makeCorner() {
  Scene scene;
  scene.addSurface({0, 0, -1.8f}, {8, 0, 0}, {0, 8, 0});
  scene.addSurface({8, 0, 2}, {0, 8, 0}, {0, 0, 3.8f});
  scene.addSurface({0, 8, 2}, {8, 0, 0}, {0, 0, 3.8f});
  return scene;
}

}  // namespace revisit_slam
