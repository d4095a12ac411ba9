// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/pose_graph/back_end_config.h"
#include "revisit_slam/types/se3.h"

namespace revisit_slam {

/// The information of an odometry edge of this length with what it may err beyond it: in the
/// directions that it knows best backend/drift and backend/turn_drift a metre. Errors of one edge
/// and the next are alike, so that edges together know less than their sum: beside factors that
/// hold the graph in the map this counts.
Matrix6 withDrift(const Matrix6& information, double metres, const BackEndConfig& config);

}  // namespace revisit_slam
