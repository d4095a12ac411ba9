// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// Parameters of SlamConfig that had another name in the release before: the old name, the new one.
/// A pair is removed one release later. Not for parameters in cfg/: dynamic_reconfigure reads those
/// from the server itself, by their new names alone.
inline const RenamedParameters kRenamedParameters{
    {"backend/pulling_weight", "backend/min_inlier_weight"},
    {"loops/agreement/rotation", "loops/consistency/rotation"},
    {"loops/agreement/rotation_drift", "loops/consistency/rotation_drift"},
    {"loops/agreement/translation", "loops/consistency/translation"},
    {"loops/agreement/translation_drift", "loops/consistency/translation_drift"},
    {"odometry/registration/finest_sigma", "odometry/registration/final_sigma"},
    {"odometry/registration/held_weight", "odometry/registration/deskew_damping"},
    {"odometry/registration/own_motion", "odometry/registration/deskew_gain"},
    {"retroactive/odometry_reach", "retroactive/low_drift_window"},
};

}  // namespace revisit_slam
