// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// Whether the numbers in a file are a pose in a map: finite, of a unit quaternion, and not so far
/// that the numbers of voxels would overflow.
inline bool isPose(const Pose& T) {
  constexpr double farthest = 1e7;  // m
  return std::abs(T.rotation.norm() - 1.0) < 1e-3 && T.translation.norm() < farthest;
}

}  // namespace revisit_slam
