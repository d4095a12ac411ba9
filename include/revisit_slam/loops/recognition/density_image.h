// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "revisit_slam/loops/recognition/place_recognition_config.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// A pixel of the endless grid that a level frame has: (i, j) covers the square from
/// (i, j) * resolution to (i + 1, j + 1) * resolution, x along i, y along j.
using Pixel = Eigen::Vector2i;

/// Bird's-eye picture of a levelled local map: how many of its points each pixel has above it, from
/// 0 to 255. Row 0 is the one of the smallest y.
struct DensityImage {
  int width = 0;
  int height = 0;
  double resolution = 0.0;           ///< m
  Pixel origin = Pixel::Zero();      ///< of the grid: where column 0 of row 0 is
  std::vector<std::uint8_t> values;  ///< row by row

  std::uint8_t at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

/// Counts go linearly from 0 for the smallest to 255 for the largest; what is below
/// `min_density` is 0. Bare ground, a single voxel, is therefore empty. Without points in range the
/// image is 0 x 0.
DensityImage densityImage(const Points& points_local, const Pose& T_level_local,
                          const DensityImageConfig& config);

}  // namespace revisit_slam
