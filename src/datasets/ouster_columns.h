// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/input/point_cloud.h"

namespace revisit_slam {

/// Times the points of an Ouster with 64 beams and 1024 columns at 10 Hz by their place in the
/// cloud, column after column as its driver wrote them until 2020, missing returns as (0, 0, 0).
/// Leaves a cloud of another number of points without times: there the columns are not known.
void addColumnTimes(PointCloud& cloud);

}  // namespace revisit_slam
