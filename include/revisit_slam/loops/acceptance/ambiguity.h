// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// How well another pose explains two submaps, as a share of how well `T_target_source` does: 0 …,
/// 1 where the surroundings repeat. Compared are poses that are shifted in the plane by 1 m (times
/// the scale of the submaps) to `radius`, m. What stands upright counts alone: ground fits
/// anywhere.
double rivalShare(const Submap& source, const Submap& target, const Pose& T_target_source,
                  double radius);

}  // namespace revisit_slam
