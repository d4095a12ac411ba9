// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "revisit_slam/geometry/voxel.h"

namespace revisit_slam {

/// Calls visit(voxel) for the voxels on the line, from the one behind that of `from` up to that of
/// `to`, as long as it returns true; coordinates in voxels (Amanatides and Woo, 1987).
template <typename Visit>
void walkVoxels(const Eigen::Vector3f& from, const Eigen::Vector3f& to, Visit visit) {
  Voxel voxel = voxelOf<float>(from);
  const Voxel way = voxelOf<float>(to) - voxel;
  const Eigen::Vector3f direction = to - from;
  Eigen::Vector3f next,
      apart;  // share of the line up to the next border, and between two, per axis
  Voxel step;
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] = way[axis] < 0 ? -1 : 1;
    const float border = static_cast<float>(voxel[axis] + (way[axis] < 0 ? 0 : 1));
    const bool crosses = way[axis] != 0;
    const float none = std::numeric_limits<float>::infinity();
    apart[axis] = crosses ? static_cast<float>(step[axis]) / direction[axis] : none;
    next[axis] = crosses ? (border - from[axis]) / direction[axis] : none;
  }
  for (int left = way.cwiseAbs().sum(); left > 0; --left) {
    const int axis =
        next.x() < next.y() ? (next.x() < next.z() ? 0 : 2) : (next.y() < next.z() ? 1 : 2);
    voxel[axis] += step[axis];
    next[axis] += apart[axis];
    if (!visit(voxel)) return;
  }
}

}  // namespace revisit_slam
