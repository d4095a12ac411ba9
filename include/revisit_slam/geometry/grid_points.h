// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "revisit_slam/geometry/voxel.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Points in the frame of a grid and the voxels that they lie in, coordinate by coordinate: loops
/// over many points at a time use the vector registers of the processor.
template <typename Scalar>
struct GridPoints {
  static constexpr std::size_t kMost = 256;

  alignas(32) Scalar x[kMost], y[kMost], z[kMost];
  alignas(32) int voxel_x[kMost], voxel_y[kMost], voxel_z[kMost];

  Eigen::Matrix<Scalar, 3, 1> point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Voxel voxel(std::size_t i) const { return {voxel_x[i], voxel_y[i], voxel_z[i]}; }
};

/// `count` points, at most kMost. `scale`: voxels per metre.
void toGrid(const Eigen::Vector3f* points, std::size_t count, const Pose& T_grid_points,
            float scale, GridPoints<float>& placed);
void toGrid(const Eigen::Vector3f* points, std::size_t count, const Pose& T_grid_points,
            double scale, GridPoints<double>& placed);
/// Of points in the frame of the grid.
void toGrid(const Eigen::Vector3f* points, std::size_t count, float scale,
            GridPoints<float>& placed);

/// Calls visit(placed, i) for each point in order.
template <typename Scalar, typename Visit>
void forEachInGrid(const Points& points, const Pose& T_grid_points, Scalar scale, Visit visit) {
  GridPoints<Scalar> placed;
  for (std::size_t begin = 0; begin < points.size(); begin += placed.kMost) {
    const std::size_t count = std::min(placed.kMost, points.size() - begin);
    toGrid(&points[begin], count, T_grid_points, scale, placed);
    for (std::size_t i = 0; i < count; ++i) visit(placed, i);
  }
}

}  // namespace revisit_slam
