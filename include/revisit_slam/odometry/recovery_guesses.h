// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/odometry/motion_predictor.h"

namespace revisit_slam {

/// Where else a scan may be that does not fit from where it was predicted: T_previous_base, farther
/// and less far along the motion, and turned. After a gap, and between scans at long intervals, the
/// prediction misses by more than the basin of ICP is wide.
std::vector<Pose> recoveryGuesses(const PredictedMotion& predicted);

}  // namespace revisit_slam
