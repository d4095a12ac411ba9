// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "revisit_slam/types/submap.h"

namespace revisit_slam {

/// Turns each normal to the nearest place that the sensor was at along the submap's trajectory.
/// Wall and slab have two sides, one a wall's thickness behind the other: the normal tells which of
/// them was seen. `sensor_base`: of the sensor in the base frame, m.
void turnToViewpoints(const Eigen::Vector3d& sensor_base, Submap& submap);

}  // namespace revisit_slam
