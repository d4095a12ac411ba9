// SPDX-License-Identifier: MIT
#pragma once

#include "revisit_slam/simulation/layout.h"
#include "revisit_slam/simulation/polyline.h"

namespace revisit_slam::simulation {

/// Parallel lanes with equal things in equal distances beside each. Lane k is the line from
/// (0, k pitch) to (length, k pitch). Metres; pitch and spacing differ by some per cent from seed
/// to seed.
struct EqualRows {
  int lanes;       ///< even
  double pitch;    ///< of the lanes
  double length;   ///< of a lane
  double spacing;  ///< of the things beside it
  double run_out;  ///< from the end of a lane to the way back
};

bool hasEqualRows(WorldKind kind);
/// Of a world that has them.
EqualRows equalRows(WorldKind kind, std::uint64_t seed);

/// Up one lane and down the next, back beside the lanes, and so on until `length` is reached.
Polyline alongRows(const EqualRows& rows, double length);

}  // namespace revisit_slam::simulation
