// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "revisit_slam/types/ids.h"
#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/se3.h"
#include "revisit_slam/types/stamp.h"

namespace revisit_slam {

enum class LocalizationState {
  searching,  ///< nothing is known of where the drive is in the map
  candidate,  ///< a place that one registration speaks for, or a pose that was given
  localized,
  lost,  ///< the odometry alone has carried the pose for too long
};

/// "searching", …
const char* toString(LocalizationState state);

/// Where a scan is in the map of an earlier session, by all that was known when it came.
struct Localization {
  ScanId scan;
  Stamp stamp;
  LocalizationState state = LocalizationState::searching;
  Pose T_map_odom;  ///< identity while searching
  Pose T_map_base;
  Matrix6 covariance = Matrix6::Zero();  ///< of T_map_base, right perturbations; while known
  double since_fix = 0.0;                ///< m, travelled since a registration passed the gates

  /// Of the last attempt to register the last metres to the map:
  bool attempted = false;                 ///< with this scan
  std::optional<SubmapId> target;         ///< none: off the map
  double overlap = 0.0, coherence = 0.0;  ///< 0 … 1
  std::string reason;                     ///< why it failed; empty: it did not
};

}  // namespace revisit_slam
