// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/types/pose.h"
#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// Levels a map on its own ground: T_level_local, in whose frame the ground is z = 0 and its normal
/// is z. The axis of the rotation is horizontal and the translation is along z, so that heading and
/// horizontal place stay. Ground is what lies lowest in each column of 1 m; the plane is fitted by
/// iterated robust least squares, which takes tilts up to about 20 degrees. The identity where the
/// points tell no plane.
Pose levelOnGround(const Points& points_local);

}  // namespace revisit_slam
