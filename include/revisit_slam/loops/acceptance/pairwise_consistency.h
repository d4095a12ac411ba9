// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "revisit_slam/loops/acceptance/gate.h"
#include "revisit_slam/util/parameters.h"

namespace revisit_slam {

/// How far two registrations between the same local maps may differ: a base plus what the odometry
/// drifts over the distance between their submaps, in both local maps.
struct PairwiseConsistencyConfig {
  double translation = 0.3;
  double translation_drift = 0.02;
  double rotation = 1.0;
  double rotation_drift = 0.02;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("translation", translation, Range{0.0, 100.0}, "m",
      "largest difference in metres between two registrations of the same local maps that are "
      "consistent; also the largest translation from its first guess of a retroactive registration "
      "that no other confirms. Raise it if right loops are rejected as inconsistent; lower it if "
      "wrong ones confirm each other");
    v("translation_drift", translation_drift, Range{0.0, 1.0}, "",
      "allowance for odometry drift, in metres for each metre between the submaps of the two "
      "registrations; none where the graph placed the submaps. Raise it if the odometry drifts "
      "more than this; lower it if it drifts less");
    v("rotation", rotation, Range{0.0, 180.0}, "deg",
      "largest rotation in degrees between two registrations of the same local maps that are "
      "consistent. Raise it if right loops are rejected as inconsistent; lower it if wrong ones "
      "confirm each other");
    v("rotation_drift", rotation_drift, Range{0.0, 10.0}, "deg/m",
      "allowance for odometry drift, in degrees for each metre between the submaps of the two "
      "registrations; none where the graph placed the submaps. Raise it if the odometry drifts "
      "more than this; lower it if it drifts less");
  }

  /// m, after a way of `travelled` m.
  double reach(double travelled) const { return translation + translation_drift * travelled; }
  /// For submaps whose places do not drift, as the graph placed them.
  PairwiseConsistencyConfig withoutDrift() const { return {translation, 0.0, rotation, 0.0}; }
};

/// Whether the odometry carries one registration over to the other within the tolerance.
bool areConsistent(const RegisteredPair& a, const RegisteredPair& b,
                   const PairwiseConsistencyConfig& config);

/// Of the registrations between two local maps the majority is right: those that are consistent
/// with the one that most are consistent with, if they are more than half of all. Measures that
/// share, and for a pair outside of the majority how far it differs.
/// @param opponents gates: the pairs that they rejected are among all, and consistent with none.
Gate consistencyGate(const PairwiseConsistencyConfig& config, std::vector<std::string> opponents);

}  // namespace revisit_slam
