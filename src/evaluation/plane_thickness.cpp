// SPDX-License-Identifier: MIT
#include "revisit_slam/evaluation/plane_thickness.h"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>

#include "revisit_slam/geometry/point_moments.h"
#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {
namespace {

/// Of each map: a plane takes three, the rest says whether it is one.
constexpr std::size_t kFewestPoints = 5;

/// The points that the maps have in one cube.
struct Cube {
  PointMoments moments;               // relative to the cube's corner
  std::vector<std::size_t> from_map;  // number of points

  bool isShared() const {
    return std::count_if(from_map.begin(), from_map.end(),
                         [](std::size_t points) { return points >= kFewestPoints; }) > 1;
  }
};

}  // namespace

PlaneThickness& PlaneThickness::operator+=(const PlaneThickness& other) {
  squared_sum += other.squared_sum;
  points += other.points;
  return *this;
}

double PlaneThickness::rms() const {
  return std::sqrt(squared_sum / static_cast<double>(points));
}

PlaneThickness planeThickness(const std::vector<Points>& maps, double edge) {
  const auto size = static_cast<float>(edge);
  tsl::robin_map<std::uint64_t, std::size_t, VoxelKeyHash> number_of;
  std::vector<Cube> cubes;  // in the order of their first points
  for (std::size_t map = 0; map < maps.size(); ++map)
    for (const Eigen::Vector3f& point : maps[map]) {
      const Voxel voxel = voxelOf<float>(point / size);
      const auto entry = number_of.try_emplace(packVoxel(voxel), cubes.size()).first;
      if (entry->second == cubes.size())
        cubes.push_back({{}, std::vector<std::size_t>(maps.size())});
      Cube& cube = cubes[entry->second];
      cube.moments.add(point - size * voxel.cast<float>());
      ++cube.from_map[map];
    }
  PlaneThickness thickness;
  for (const Cube& cube : cubes) {
    if (!cube.isShared()) continue;
    const double points = cube.moments.count;
    thickness.squared_sum += points * cube.moments.principalAxes().variances[0];
    thickness.points += static_cast<std::size_t>(points);
  }
  return thickness;
}

}  // namespace revisit_slam
