// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace revisit_slam {

/// Whether a point of a submap, in its frame (m), may be in it. What lies farther from the keypose
/// is in no submap, and would overflow the map; what is no number is nowhere.
inline bool isInBounds(const Eigen::Vector3f& p_submap) {
  constexpr float farthest = 1e4f;  // m
  return (p_submap.array().abs() < farthest).all();
}

}  // namespace revisit_slam
