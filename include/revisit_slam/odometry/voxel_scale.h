// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/local_voxel_map.h"

namespace revisit_slam {

/// The edge of the voxels that scans are registered with. It is the configured one where scans
/// reach far. In rooms a neighbourhood of such voxels would hold floor, walls and furniture at
/// once, and none of them could be told apart: the edge is halved while scans reach less than ten
/// edges, or while a ceiling is less than five edges above the floor, as in a garage, and doubled,
/// up to the configured one, once scans reach forty edges and no ceiling is within ten: a factor of
/// two from where it is halved, so that the edge does not change back and forth. What is level less
/// than 1.5 m, and than a quarter of that reach, above the floor is no ceiling.
class VoxelScale {
 public:
  /// `largest`: m, the configured edge. `adaptive`: false keeps it.
  VoxelScale(double largest, bool adaptive)
      : largest_(largest), adaptive_(adaptive), voxel_size_(largest) {}

  double voxelSize() const { return voxel_size_; }

  /// Takes note of a scan of the drive. `reach`: m, the median distance of its down-sampled points
  /// from the sensor.
  void observe(double reach);

  /// Follows what was observed, with a map that has such voxels. @return whether voxelSize changed.
  bool follow(const LocalVoxelMap& map);

  /// The same, down only.
  bool shrink(const LocalVoxelMap& map);

 private:
  bool isUnderCeiling(const LocalVoxelMap& map, int highest) const;

  double largest_;
  bool adaptive_;
  double voxel_size_;
  double reach_ = 0.0;
};

}  // namespace revisit_slam
