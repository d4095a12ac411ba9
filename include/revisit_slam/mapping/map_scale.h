// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace revisit_slam {

/// How maps follow the size of the place, which the odometry tells by the voxels that it registers
/// with (VoxelScale).
struct MapScale {
  bool follows = false;
  double largest_voxel_size = 1.0;  ///< m, of the odometry: of places of full size

  /// Of submaps and local maps, as a share of the configured one. `voxel_size`: m, of a scan
  /// (RegisteredScan::voxel_size); 0: not known.
  double sizeOf(double voxel_size) const {
    if (!follows || voxel_size <= 0.0) return 1.0;
    return std::min(1.0, voxel_size / largest_voxel_size);
  }

  /// Of their voxels, likewise. Maps of half the size, as in garages, keep their voxels: with 16
  /// beams finer ones are sparse.
  double scaleOf(double voxel_size) const {
    constexpr double fineness = 2.0;
    return std::min(1.0, fineness * sizeOf(voxel_size));
  }
};

}  // namespace revisit_slam
