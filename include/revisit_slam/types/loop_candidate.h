// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "revisit_slam/types/constraint.h"
#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// A pair of submaps that was registered as a possible loop, and what the gates decided, for tables
/// and logs.
struct LoopCandidate {
  LoopOrigin origin = LoopOrigin::appearance;
  LocalMapId target_map, source_map;
  SubmapId target, source;
  std::string outcome;  ///< "accepted", or the gate that rejected it
  /// Of that gate.
  double value = 0.0, limit = 0.0;
  std::string unit;

  bool isAccepted() const { return outcome == "accepted"; }
};

}  // namespace revisit_slam
