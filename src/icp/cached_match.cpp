// SPDX-License-Identifier: MIT
#include "revisit_slam/icp/cached_match.h"

namespace revisit_slam {

bool CachedMatch::search(const Eigen::Vector3d& p_odom, const LocalVoxelMap& map,
                         double max_distance) {
  searched_at_ = p_odom;
  valid_ = map.nearest(p_odom, max_distance, neighbour_);
  return valid_ && (p_odom - neighbour_.point_odom).norm() < max_distance;
}

}  // namespace revisit_slam
