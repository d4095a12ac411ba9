// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "revisit_slam/types/scan.h"

namespace revisit_slam {

/// How a spinning sensor sweeps, seen from above.
struct AzimuthSweep {
  bool clockwise = true;
  /// Degrees counter-clockwise from the x axis.
  double start = 180.0;
};

/// The part of the sweep that had passed when each point was measured, in [0, 1), to 1e-6.
std::vector<float> sweepFractions(const Points& points, const AzimuthSweep& sweep);

}  // namespace revisit_slam
