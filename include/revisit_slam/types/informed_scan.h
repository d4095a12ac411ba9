// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "revisit_slam/types/information_estimate.h"
#include "revisit_slam/types/registered_scan.h"
#include "revisit_slam/util/stage_times.h"

namespace revisit_slam {

/// Whether the information of an edge was estimated from the scan itself.
enum class InformationSource {
  estimated,
  repeated,   ///< the estimator fell behind: that of the scan before
  predicted,  ///< not registered: that of the predicted motion
  identity,   ///< nothing to estimate from: the first scan, or information switched off
};

const char* toString(InformationSource source);

/// A registered scan with the information of the odometry edge that leads to it.
struct InformedScan {
  RegisteredScanPtr scan;
  InformationEstimate estimate;
  InformationSource source = InformationSource::identity;
  PoseVerdict verdict = PoseVerdict::good;  ///< of all that is known
  /// Of the motion since the scan before, for right perturbations: [m; rad] in the base frame.
  Matrix6 covariance_motion = Matrix6::Identity();
  /// Of T_odom_base, likewise, as it has grown since the session's first scan.
  Matrix6 covariance_pose = Matrix6::Zero();
  StageTimes times;  ///< of the odometry and of the information
};

}  // namespace revisit_slam
