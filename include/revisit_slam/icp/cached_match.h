// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/icp/local_voxel_map.h"

namespace revisit_slam {

/// The match of a source point in the map, kept from one iteration of ICP to the next: while the
/// point has moved less than the rivals of its neighbour are farther, the neighbour is still the
/// nearest.
class CachedMatch {
 public:
  /// Finds the map point nearest to the source point at `p_odom`; as exact as a search of the map.
  /// @return whether it is nearer than `max_distance`.
  bool update(const Eigen::Vector3d& p_odom, const LocalVoxelMap& map, double max_distance) {
    if (valid_) {
      const double distance = (p_odom - neighbour_.point_odom).norm();
      const double moved = (p_odom - searched_at_).norm();
      if (distance + moved + kBoundMargin <= neighbour_.rival_distance)
        return distance < max_distance;
    }
    return search(p_odom, map, max_distance);
  }

  /// After an update that found one.
  const Neighbour& neighbour() const { return neighbour_; }

 private:
  /// The bounds on distances are floats of values below 20 m.
  static constexpr double kBoundMargin = 1e-5;

  bool search(const Eigen::Vector3d& p_odom, const LocalVoxelMap& map, double max_distance);

  Eigen::Vector3d searched_at_;
  Neighbour neighbour_;
  bool valid_ = false;
};

}  // namespace revisit_slam
