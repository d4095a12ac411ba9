// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "revisit_slam/types/pose.h"

namespace revisit_slam {

/// The same point in the map, by odometry and loops, and in east, north, up, by GNSS.
struct PositionPair {
  Eigen::Vector3d p_map, p_enu;
  double deviation = 1.0;           ///< m, horizontal, of p_enu
  double vertical_deviation = 1.0;  ///< m
};

struct EnuAlignment {
  Pose T_map_enu;              ///< yaw and translation
  double yaw_deviation = 0.0;  ///< rad, by the deviations of the pairs that fit
};

/// The yaw and translation between both frames, whose z axes are taken for parallel, that most of
/// the pairs agree with: the best of many that two pairs give, refined with cauchy kernels of this
/// scale (standard deviations). Nothing for less than three pairs, or pairs at one place.
std::optional<EnuAlignment> alignToEnu(const std::vector<PositionPair>& pairs, double kernel_scale);

}  // namespace revisit_slam
