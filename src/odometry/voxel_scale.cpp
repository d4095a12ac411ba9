// SPDX-License-Identifier: MIT
#include "revisit_slam/odometry/voxel_scale.h"

#include <algorithm>
#include <cmath>

namespace revisit_slam {
namespace {

constexpr double kSmallest = 0.02;     ///< m
constexpr double kFewestEdges = 10.0;  ///< that scans reach
constexpr int kLowCeiling = 4;         ///< edges above the floor
/// m above the floor, and of the reach. Foliage, furniture and the noise of points are level here
/// and there, too, and the smaller the voxels, the more of them: without a limit, standing under a
/// tree halved the edge down to 4 cm.
constexpr double kLowestCeiling = 1.5, kLowestCeilingShare = 0.25;
/// Of the level ground in the local map, under a low ceiling. First scans and local maps of garages
/// with 16 to 32 beams have 0.05 to 0.19, those of streets up to 0.035 (what is under trees).
constexpr double kCoveredShare = 0.05;
/// Of a new scan in the reach: what is seen through a door or behind a bend for a second is no
/// reason to change.
constexpr double kShare = 0.1;

}  // namespace

void VoxelScale::observe(double reach) {
  reach_ = reach_ == 0.0 ? reach : reach_ + kShare * (reach - reach_);
}

bool VoxelScale::shrink(const LocalVoxelMap& map) {
  if (!adaptive_ || 0.5 * voxel_size_ < kSmallest) return false;
  if (reach_ >= kFewestEdges * voxel_size_ && !isUnderCeiling(map, kLowCeiling)) return false;
  voxel_size_ *= 0.5;
  return true;
}

/// `highest`: edges above the floor.
bool VoxelScale::isUnderCeiling(const LocalVoxelMap& map, int highest) const {
  const double height = std::min(kLowestCeiling, kLowestCeilingShare * reach_);
  const int lowest = std::max(2, static_cast<int>(std::ceil(height / voxel_size_)));
  return lowest <= highest && map.coveredShare(lowest, highest) >= kCoveredShare;
}

bool VoxelScale::follow(const LocalVoxelMap& map) {
  if (shrink(map)) return true;
  if (!adaptive_ || voxel_size_ >= largest_ || reach_ < 4.0 * kFewestEdges * voxel_size_ ||
      isUnderCeiling(map, 2 * (kLowCeiling + 1)))
    return false;
  voxel_size_ *= 2.0;
  return true;
}

}  // namespace revisit_slam
