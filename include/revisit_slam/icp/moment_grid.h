// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "revisit_slam/geometry/point_moments.h"
#include "revisit_slam/geometry/voxel_numbers.h"

namespace revisit_slam {

/// The moments of the points in each cube of a grid.
class MomentGrid {
 public:
  /// `edge`: of a cube, metres.
  explicit MomentGrid(double edge) : edge_(edge) {}

  void add(const Eigen::Vector3d& point);
  /// Of the points in the cube that the place lies in and the 26 around it, relative to the place.
  PointMoments around(const Eigen::Vector3d& place) const;
  /// Drops every cube whose centre is farther than `distance` from `centre`.
  void dropBeyond(const Eigen::Vector3d& centre, double distance);

  std::size_t size() const { return cube_of_.size(); }

 private:
  struct Cube {
    Voxel place;
    PointMoments moments;  // from its corner; no points: the entry is free
  };

  double edge_;
  VoxelNumbers cube_of_;
  std::vector<Cube> cubes_;
  std::vector<std::uint32_t> free_;
};

}  // namespace revisit_slam
